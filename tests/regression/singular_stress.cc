// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Vertices of curved sides and ends of material interfaces: those where theory (Williams; Bogy for two
// materials) has an infinite stress are told of, their regular neighbours are not.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

using namespace abut::testing;

namespace
{
  /// How many of Output/Points are said to have an infinite stress.
  std::size_t n_singular_points(const std::string &scene, const std::string &points)
  {
    const Answer answer = run_text(scene, {"Output/Points=" + points});
    EXPECT_EQ(answer.status, 0) << answer.err;
    std::size_t n = 0;
    for (const auto &warning : answer.summary["warnings"])
      if (warning["code"] == "singular-stress" &&
          warning["message"].get<std::string>().find("one of Output/Points") != std::string::npos)
        ++n;
    return n;
  }

  std::string outlined(const std::string &outline, const std::string &conditions,
                       const std::string &degree = "2")
  {
    return "set Bodies = b\nsubsection Body b\n set Shape = outline\n set Outline = " + outline +
           "\n set Mesh size = 0.3\n set Degree = " + degree +
           "\n set Young modulus = 1000\n set Conditions = " + conditions + "\nend\n";
  }

  const std::string two_arcs = "(1,0) -> a: arc (0,1) (-1,0) -> b: arc (0,-1) (1,0)",
                    held_points = "(1,0): displacement: 0, 0; (-1,0): displacement y: 0",
                    quarter_outline = "(0,0) -> low: (1,0) -> round: centre (0,0) (0,1) -> left: close";

  /// A regular polygon, as a mesh file may give for a circle; all its edges are one side.
  std::string faceted_circle(const int n_edges)
  {
    const double step = 2. * std::acos(-1.) / n_edges;
    std::string outline = "(1,0)";
    for (int i = 1; i < n_edges; ++i)
      outline +=
          " -> a: (" + std::to_string(std::cos(i * step)) + "," + std::to_string(std::sin(i * step)) + ")";
    return outline + " -> a: close";
  }
} // namespace

TEST(SingularStress, AtANotchBetweenALineAndAnArc)
{
  const std::string outline = "(-2,0) -> bot: (2,0) -> r: (2,2) -> t1: (0,2) -> n1: (0,1) -> "
                              "n2: arc (-0.6,1.3) (-1,2) -> t2: (-2,2) -> l: close";
  for (const std::string degree : {"1", "2"})
    EXPECT_EQ(
        n_singular_points(
            outlined(outline, "l: displacement x: 0; r: traction: 1, 0; bot: displacement y: 0", degree),
            "(0,1); (2,2); (2,0); (-1,2)"),
        1u)
        << degree;
}

TEST(SingularStress, WhereASupportEndsOnACircle)
{
  EXPECT_EQ(n_singular_points(outlined(two_arcs, "a: displacement: 0, 0; b: pressure: 1"),
                              "(1,0); (-1,0); (0,1); (0,-1)"),
            2u);
}

TEST(SingularStress, WhereAClampedLineMeetsAFreeArc)
{
  EXPECT_EQ(
      n_singular_points(outlined(quarter_outline, "low: displacement: 0, 0; left: normal displacement: 0"),
                        "(1,0); (0,1)"),
      1u);
}

TEST(SingularStress, NotOnACircleWithOneCondition)
{
  for (const std::string degree : {"1", "2"})
    EXPECT_EQ(n_singular_points(outlined(two_arcs, "a: pressure: 1; b: pressure: 1; " + held_points, degree),
                                "(1,0); (-1,0); (0,1); (0,-1)"),
              0u);
  EXPECT_EQ(n_singular_points(outlined(two_arcs,
                                       "a: normal displacement: -1e-3; b: normal displacement: -1e-3; (1,0): "
                                       "displacement y: 0"),
                              "(1,0); (-1,0)"),
            0u);
}

TEST(SingularStress, NotWhereAnArcGoesOnAsALine)
{
  EXPECT_EQ(
      n_singular_points(outlined("(-1,-1) -> low: (1,-1) -> right: arc (2,0) (1,1) -> top: (-1,1) -> "
                                 "left: arc (-2,0) (-1,-1)",
                                 "low: pressure: 1; right: pressure: 1; top: pressure: 1; left: pressure: 1; "
                                 "(1,-1): displacement: 0, 0; (-1,-1): displacement y: 0"),
                        "(1,1); (-1,1); (1,-1); (-1,-1)"),
      0u);
}

TEST(SingularStress, NotAtFacetsThatStandForACircle)
{
  EXPECT_EQ(n_singular_points(outlined(faceted_circle(24), "a: pressure: 1; " + held_points), "(1,0); (0,1)"),
            0u);
}

TEST(SingularStress, NotWhereAPlaneOfSymmetryMeetsAFreeArcAtARightAngle)
{
  for (const std::string load : {"", "; round: pressure: 1"})
    EXPECT_EQ(n_singular_points(outlined(quarter_outline,
                                         "low: normal displacement: 0; left: normal displacement: 0" + load),
                                "(1,0); (0,1); (0,0)"),
              0u);
}

/// The free edge of two materials; not at a plane of symmetry, nor where both are the same one.
TEST(SingularStress, WhereAnInterfaceOfMaterialsEnds)
{
  const std::string layers = temporary_file(
      "two.geo", "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0,0,0,2,1}; Rectangle(2) = {0,1,0,2,1};\n"
                 "BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }\n"
                 "Physical Surface(\"p\") = {1}; Physical Surface(\"q\") = {2};\n"
                 "left() = Curve In BoundingBox {-.1, -.1, -.1, .1, 2.1, .1};\n"
                 "right() = Curve In BoundingBox {1.9, -.1, -.1, 2.1, 2.1, .1};\n"
                 "low() = Curve In BoundingBox {-.1, -.1, -.1, 2.1, .1, .1};\n"
                 "top() = Curve In BoundingBox {-.1, 1.9, -.1, 2.1, 2.1, .1};\n"
                 "Physical Curve(\"left\") = {left()}; Physical Curve(\"right\") = {right()};\n"
                 "Physical Curve(\"low\") = {low()}; Physical Curve(\"top\") = {top()};\n");
  const auto scene = [&](const std::string &modulus) {
    return "set Bodies = b\nset Materials = mp, mq\n"
           "subsection Material mp\n set Young modulus = 1\n set Poisson ratio = 0.3\nend\n"
           "subsection Material mq\n set Young modulus = " +
           modulus +
           "\n set Poisson ratio = 0.3\nend\n"
           "subsection Body b\n set Mesh file = " +
           layers +
           "\n set Mesh size = 0.25\n set Degree = 2\n set Regions = p: mp; q: mq\n"
           " set Conditions = low: displacement y: 0; left: normal displacement: 0; top: pressure: 0.01\n"
           "end\n";
  };
  EXPECT_EQ(n_singular_points(scene("1000"), "(2,1)"), 1u);
  EXPECT_EQ(n_singular_points(scene("1000"), "(0,1); (1,1); (2,2)"), 0u);
  EXPECT_EQ(n_singular_points(scene("1"), "(2,1); (0,1)"), 0u);
}

/// A quarter disc glued into a quarter ring: the seam meets the cuts at right angles.
TEST(SingularStress, WhereACurvedSeamEndsButAtPlanesOfSymmetry)
{
  const auto scene = [](const std::string &cut) {
    return "set Bodies = b\nsubsection Part in\n set Shape = quarter disc\n set Size = 1\n"
           " set Cells = 8, 4\n set Young modulus = 1\nend\n"
           "subsection Part out\n set Shape = quarter ring\n set Size = 1, 2\n set Cells = 12, 6\n"
           " set Young modulus = 1000\nend\n"
           "subsection Body b\n set Shape = glued parts\n set Parts = in, out\n"
           " set Conditions = in.bottom + out.bottom: normal displacement: 0; out.outer: pressure: 1" +
           cut + "\nend\n";
  };
  const std::string held = "; in.left + out.left: normal displacement: 0";
  EXPECT_EQ(n_singular_points(scene(held), "(1,0); (0,1)"), 0u);
  EXPECT_GE(n_singular_points(scene("; out.left: displacement x: 0"), "(0,1)"), 1u);
  EXPECT_EQ(n_singular_points(scene("; out.left: displacement x: 0"), "(1,0)"), 0u);
}
