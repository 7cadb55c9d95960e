// Lower half of an ellipse with the half axes 2 and 1: its lowest point has the radius of curvature 4.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 2, 1};
Rectangle(2) = {-3, -2, 0, 6, 2};
BooleanIntersection(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
e() = Abs(Boundary{ Surface{3}; });
face() = {}; round() = {};
For i In {0:#e()-1}
  b() = BoundingBox Curve{e(i)};
  If (b(1) > -1e-3)
    face() += e(i);
  Else
    round() += e(i);
  EndIf
EndFor
Physical Curve("face") = face();
Physical Curve("round") = round();
Physical Surface("cam") = {3};
MeshSize{ PointsOf{ Surface{3}; } } = 0.25;
