// SPDX-License-Identifier: LGPL-2.1-or-later
// The curves behind the straight edges of mesh files, and the cells that follow them.
#include <abut/mesh/gmsh_library.h>

#include "../mesh_text.h"
#include "mesh_testing.h"

using namespace abut;

namespace
{
  void refine(BodyMesh &mesh)
  {
    mesh.triangulation.refine_global(1);
  }
} // namespace

TEST(MeshCurves, RefinedRingsHaveTheirAreaAndLengths)
{
  for (const bool triangles : {false, true})
  {
    const auto body = body_from_text("ring.msh", quarter_ring(6, triangles));
    const auto mesh = make_mesh(body);
    ASSERT_TRUE(mesh->curved);
    const double straight_error = std::abs(area(*mesh, 1) - .75 * pi);
    // Degree 1: the polygon of vertices on the circle, whose area lacks a quarter as much with every split.
    refine(*mesh);
    EXPECT_NEAR(std::abs(area(*mesh, 1) - .75 * pi) / straight_error, .25, .01);
    refine(*mesh);
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() <= 2)
          for (const unsigned int v : {0, 1})
          {
            EXPECT_NEAR(face->vertex(v).norm(), face->boundary_id() == 1 ? 1. : 2., 2e-7);
          }
    // Degree 2: order 4.
    EXPECT_NEAR(area(*mesh, 2), .75 * pi, 1e-6);
    EXPECT_NEAR(side_length(*mesh, "bore", 2), .5 * pi, 1e-6);
    EXPECT_GT(smallest_jacobian(*mesh, 2), .4);
  }
}

TEST(MeshCurves, PlacedCurvesMoveWithTheBody)
{
  auto body = body_from_text("placed.msh", quarter_ring(6, false));
  body.placement = Placement(3., true, 35., {1., -2.});
  const auto mesh = make_mesh(body);
  refine(*mesh);
  EXPECT_NEAR(area(*mesh, 2), 9. * .75 * pi, 1e-4);
  for_each_edge(body, *mesh, "bore", [](const Vector2 &a, const Vector2 &b) {
    EXPECT_NEAR(a.norm(), 1., 2e-7);
    EXPECT_NEAR(b.norm(), 1., 2e-7);
  });
}

TEST(MeshCurves, AsMeshedIsThePolygon)
{
  auto body = body_from_text("as_meshed.msh", quarter_ring(6, false));
  body.boundary_curve = BoundaryCurve::as_meshed;
  const auto mesh = make_mesh(body);
  EXPECT_FALSE(mesh->curved);
  const double before = area(*mesh, 1);
  refine(*mesh);
  EXPECT_NEAR(area(*mesh, 1), before, 1e-14);
  const SideFacets &facets = mesh->facets.at(2);
  EXPECT_EQ(facets.n_edges, 6u);
  EXPECT_NEAR(facets.largest_kink, 15., 1e-10);
  EXPECT_NEAR(facets.height, 2. * (1. - std::cos(7.5 * pi / 180.)), 2e-3 * facets.height);
  EXPECT_FALSE(facets.followed);
}

TEST(MeshCurves, CornersBelowTheCornerAngleAreNamed)
{
  auto body = body_from_text("coarse.msh", quarter_ring(3, false)); // 30 degrees a kink
  EXPECT_EQ(make_mesh(body)->facets.at(1).n_blunt_corners, 1u);
  body.corner_angle = 31.;
  const auto mesh = make_mesh(body);
  EXPECT_EQ(mesh->facets.at(1).n_blunt_corners, 0u);
  EXPECT_NEAR(side_length(*mesh, "1", 3), .5 * pi, 1e-3);
}

TEST(MeshCurves, GeometryFilesAreMeshedOnTheirCurves)
{
  const std::string quarter =
      "Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {2,0,0}; Point(4) = {0,2,0};\n"
      "Point(5) = {0,1,0}; Line(1) = {2,3}; Circle(2) = {3,1,4}; Line(3) = {4,5};\n"
      "Circle(4) = {5,1,2}; Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\n";
  auto body = body_from_text("ring.geo", quarter);
  body.corner_angle = 31.;
  expect_refused([&] { make_mesh(body); }, "Corner angle is given, but the curves of a geometry");
  body.corner_angle = BodyDescription().corner_angle;
  for (const double size : {.6, .3})
    for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
    {
      body.mesh_size.everywhere = size;
      body.cell_type = type;
      const auto mesh = make_mesh(body);
      EXPECT_EQ(mesh->cell_type, type);
      // No physical lines: sides by the numbers of the curves.
      EXPECT_EQ(mesh->boundaries.size(), 4u);
      refine(*mesh);
      EXPECT_NEAR(area(*mesh, 2), .75 * pi, 1e-2 * std::pow(size, 4));
      for_each_edge(body, *mesh, "4",
                    [](const Vector2 &a, const Vector2 &) { EXPECT_NEAR(a.norm(), 1., 1e-10); });
    }
  // A named line, and the error in a line of the file.
  body = body_from_text("named.geo", quarter + "Physical Curve(\"bore\", 7) = {4};\n");
  EXPECT_EQ(boundary_id(*make_mesh(body), "bore"), 7u);
  body = body_from_text("wrong.geo", quarter + "Plane Surface(2) = {;\n");
  expect_refused([&] { make_mesh(body); }, "the Gmsh library cannot read it (line 4: syntax error");
}

TEST(MeshCurves, OutlinesAreMeshedOnTrueArcs)
{
  BodyDescription body = make_body("outline", {}, {{1, 1}});
  body.outline = parse_outline(
      "(1, 0) -> (2, 0) -> rim: centre (0, 0) (0, 2) -> (0, 1) -> bore: centre (0, 0) (1, 0)", {}, "Outline");
  body.mesh_size = parse_mesh_size("0.5; bore: 0.1", {}, "Mesh size");
  for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
  {
    body.cell_type = type;
    const auto mesh = make_mesh(body);
    EXPECT_EQ(mesh->cell_type, type);
    EXPECT_NEAR(area(*mesh, 2), .75 * pi, 1e-4);
    EXPECT_NEAR(side_length(*mesh, "rim", 2), pi, 1e-4);
    EXPECT_GE(mesh->facets.at(boundary_id(*mesh, "bore")).n_edges, 12u); // edges of .1
    EXPECT_LE(mesh->facets.at(boundary_id(*mesh, "rim")).n_edges, 12u);  // less where no size is asked for
  }
  body.mesh_size = parse_mesh_size("0.5; hole: 0.1", {}, "Mesh size");
  expect_refused([&] { make_mesh(body); }, "Mesh size names a side `hole`, there is none");
}

TEST(MeshCurves, CornersOfCellsAreNotFlat)
{
  // A disc: coarse cells of the mesher have two edges on the rim, unless that is mended.
  BodyDescription body = make_body("outline", {}, {{1, 1}});
  body.outline = parse_outline("rim: circle (0, 0) 1", {}, "Outline");
  for (const unsigned int degree : {1u, 2u, 3u})
    for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
    {
      body.cell_type = type;
      body.degree = degree;
      if (type == CellType::triangles && degree == 3)
      {
        expect_refused([&] { make_mesh(body); }, "degree 3 refused for triangles");
        continue;
      }
      const auto mesh = make_mesh(body);
      EXPECT_EQ(mesh->cell_type, type);
      refine(*mesh);
      EXPECT_GT(smallest_jacobian(*mesh, degree), .1);
      EXPECT_NEAR(area(*mesh, degree), pi, degree == 1 ? .02 : 1e-4);
    }
}

TEST(MeshCurves, OnlyPhysicalSurfacesAreThePart)
{
  const std::string squares =
      "Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {1,1,0}; Point(4) = {0,1,0};\n"
      "Point(5) = {2,0,0}; Point(6) = {2,1,0};\n"
      "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n"
      "Line(5) = {2,5}; Line(6) = {5,6}; Line(7) = {6,3};\n"
      "Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\n"
      "Curve Loop(2) = {5,6,7,-2}; Plane Surface(2) = {2};\n"
      "Physical Curve(\"right\") = {2};\n";
  EXPECT_NEAR(area(*make_mesh(body_from_text("left.geo", squares + "Physical Surface(1) = {1};\n")), 1), 1.,
              1e-12);
  EXPECT_NEAR(area(*make_mesh(body_from_text("both.geo", squares + "Physical Surface(1) = {1, 2};\n"
                                                                   "Physical Curve(\"end\") = {6};\n")),
                   1),
              2., 1e-12);
}

TEST(MeshCurves, SidesTakenTogether)
{
  const auto mesh = make_mesh(body_from_text("united.msh", quarter_ring(4, false)));
  const double both = side_length(*mesh, "bore", 1) + side_length(*mesh, "2", 1);
  unite_sides(*mesh, "bore + 2");
  EXPECT_NEAR(side_length(*mesh, "bore + 2", 1), both, 1e-12);
  EXPECT_EQ(mesh->facets.at(boundary_id(*mesh, "bore + 2")).n_edges, 8u);
  expect_refused([&] { boundary_id(*mesh, "2"); },
                 "has no side '2'; its sides are bore + 2 from (1, 0) to (2, 0) and from (0, 1) to (0, 2), 3 "
                 "from (1, 0) to (2, 0), 4");
  expect_refused([&] { unite_sides(*mesh, "3 + 3"); }, "has `3` twice");
  expect_refused([&] { unite_sides(*mesh, "3 + 9"); }, "has no side '9'");
}

TEST(MeshCurves, BuiltInShapesDoNotStartTheLibrary)
{
  const unsigned int before = GmshLibrary::n_starts();
  make_mesh(make_body("ring", {1., 2.}, {{4, 2}}));
  EXPECT_EQ(GmshLibrary::n_starts(), before);
  make_mesh(body_from_text("once.msh", quarter_ring(3, false)));
  EXPECT_EQ(GmshLibrary::n_starts(), before + 1);
}
