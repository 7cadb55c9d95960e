// SPDX-License-Identifier: LGPL-2.1-or-later
// Cell quality, names of sides, depth behind a side.
#include <abut/mesh/quality.h>

#include "mesh_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  double depth(const BodyDescription &body, const std::string &side)
  {
    const auto mesh = make_mesh(body);
    return contact_depth(body, *mesh, boundary_id(*mesh, side));
  }
} // namespace

TEST(MeshMeasures, QualityOfSquares)
{
  auto body = make_body("rectangle", {3., 2.}, {{3, 2}});
  // Each of the four triangles has legs 1, 1: circles of diameters sqrt(2) and 2 - sqrt(2).
  auto quality = mesh_quality(*make_mesh(body));
  EXPECT_NEAR(quality.h_max, std::sqrt(2.), 1e-14);
  EXPECT_NEAR(quality.regularity, 1. + std::sqrt(2.), 1e-14);

  body.cell_type = CellType::triangles;
  quality = mesh_quality(*make_mesh(body));
  EXPECT_NEAR(quality.h_max, std::sqrt(2.), 1e-14);
  EXPECT_NEAR(quality.regularity, 1. + std::sqrt(2.), 1e-14);
}

TEST(MeshMeasures, QualityOfAThreeFourRectangle)
{
  // Legs 3, 4, hypotenuse 5: circles of diameters 5 and 2.
  const auto mesh = make_mesh(make_body("rectangle", {3., 4.}, {{1, 1}}));
  const auto quality = mesh_quality(*mesh);
  EXPECT_NEAR(quality.h_max, 5., 1e-14);
  EXPECT_NEAR(quality.regularity, 2.5, 1e-14);
}

TEST(MeshMeasures, QualityTakesTheWorstTriangleOfACell)
{
  // Over [0, 1] the top rises from 1 to 2. By hand: corners (0,0), (1,0), (0,1), (1,2). The largest
  // circumscribed circle belongs to (0,0), (0,1), (1,2): sides 1, sqrt(2), sqrt(5), area 1/2.
  auto body = make_body("rectangle with curved top", {1., 1.}, {{1, 1}});
  body.top = Expression("1 + x", {}, "test");
  const auto quality = mesh_quality(*make_mesh(body));
  EXPECT_NEAR(quality.h_max, std::sqrt(10.), 1e-14);
  EXPECT_NEAR(quality.regularity, std::sqrt(10.) * (1. + std::sqrt(2.) + std::sqrt(5.)) / 2., 1e-13);
}

TEST(MeshMeasures, RefiningHalvesTheSizeAndKeepsTheShape)
{
  const auto mesh = make_mesh(make_body("rectangle", {3., 4.}, {{2, 2}}));
  const auto coarse = mesh_quality(*mesh);
  mesh->triangulation.refine_global(1);
  const auto fine = mesh_quality(*mesh);
  EXPECT_NEAR(fine.h_max, 0.5 * coarse.h_max, 1e-14);
  EXPECT_NEAR(fine.regularity, coarse.regularity, 1e-14);
}

TEST(MeshMeasures, UnknownSidesAreRefusedWithTheKnownOnes)
{
  const auto mesh = make_mesh(make_body("quarter disc", {1.}, {{2, 1}}));
  EXPECT_NO_THROW(boundary_id(*mesh, "outer"));
  expect_refused([&] { boundary_id(*mesh, "top"); }, "'top'; its sides are outer, left, bottom");
}

TEST(MeshMeasures, DepthOfShapes)
{
  auto body = make_body("rectangle", {4., 1.5}, {{4, 3}});
  body.placement = Placement(2., true, 37., {10., -20.});
  EXPECT_NEAR(depth(body, "top"), 3., 1e-12);
  EXPECT_NEAR(depth(body, "left"), 8., 1e-12);
  body.contact_depth = 0.7;
  EXPECT_NEAR(depth(body, "top"), 1.4, 1e-14);

  EXPECT_NEAR(depth(make_body("disc", {3.}, {{2, 1}}), "outer"), 3., 1e-14);
  EXPECT_NEAR(depth(make_body("half disc", {3.}, {{2, 1}}), "bottom"), 3., 1e-14);
  EXPECT_NEAR(depth(make_body("quarter ring", {3., 4.5}, {{2, 1}}), "inner"), 1.5, 1e-14);
}

TEST(MeshMeasures, DepthUnderACurvedTop)
{
  // The top is symmetric: its mean normal is (0, 1), its highest point 1.25.
  auto body = make_body("rectangle with curved top", {1., 1.}, {{4, 2}});
  body.top = Expression("1 + x*(1 - x)", {}, "test");
  EXPECT_NEAR(depth(body, "top"), 1.25, 1e-13);
}

TEST(MeshMeasures, DepthBehindAClosedSideIsHalfTheDiameter)
{
  for (const CellType cell_type : {CellType::quadrilaterals, CellType::triangles})
  {
    auto body = make_body("rectangle", {3., 2.}, {{3, 2}});
    body.cell_type = cell_type;
    body.placement = Placement(1., false, 37., {0., 0.});
    const auto mesh = make_mesh(body);
    for (const auto &face : mesh->triangulation.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(1);
    EXPECT_NEAR(contact_depth(body, *mesh, 1), std::sqrt(13.) / 2., 1e-14);
  }
}
