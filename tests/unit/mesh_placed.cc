// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that are moved, turned, mirrored, scaled, and refined afterwards.
#include "mesh_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  const std::vector<Placement> placements = {
      Placement(1., false, 0., {3., -2.}), Placement(1., true, 0., {0., 0.}),
      Placement(1., false, 90., {0., 1.}), Placement(2.5, true, 37., {1000., -3.}),
      Placement(0.1, false, 200., {-1., 5.})};
} // namespace

TEST(MeshPlaced, SidesKeepTheirNames)
{
  for (const CellType cell_type : {CellType::quadrilaterals, CellType::triangles})
    for (const auto &placement : placements)
    {
      auto body = make_body("rectangle", {4., 1.5}, {{4, 3}});
      body.cell_type = cell_type;
      body.placement = placement;
      const auto mesh = make_mesh(body);
      const double scale = placement.length_to_world(1.);
      EXPECT_NEAR(area(*mesh, 1) / (scale * scale), 6., 1e-11);
      if (cell_type == CellType::quadrilaterals)
      {
        EXPECT_NEAR(smallest_jacobian(*mesh, 1), 1., 1e-10);
      }
      expect_all_sides_named(*mesh);
      const auto expect = [&](const std::string &side, const int component, const double value) {
        for_each_edge(body, *mesh, side, [&](const Vector2 &a, const Vector2 &b) {
          EXPECT_NEAR(a[component], value, 1e-11);
          EXPECT_NEAR(b[component], value, 1e-11);
        });
      };
      expect("left", 0, 0.);
      expect("right", 0, 4.);
      expect("bottom", 1, 0.);
      expect("top", 1, 1.5);
    }
}

TEST(MeshPlaced, RefinedDiscsAndRingsStayRound)
{
  for (const auto &placement : placements)
  {
    for (const std::string shape : {"disc", "half disc", "quarter disc", "ring", "quarter ring"})
    {
      const bool is_ring = shape == "ring" || shape == "quarter ring";
      auto body =
          make_body(shape, is_ring ? std::vector<double>{0.5, 1.} : std::vector<double>{1.}, {{4, 2}});
      body.placement = placement;
      const auto mesh = make_mesh(body);
      mesh->triangulation.refine_global(1);
      const auto expect_radius = [&](const std::string &side, const double radius) {
        for_each_edge(body, *mesh, side, [&](const Vector2 &a, const Vector2 &b) {
          EXPECT_NEAR(a.norm(), radius, 1e-12);
          EXPECT_NEAR(b.norm(), radius, 1e-12);
        });
      };
      expect_radius("outer", 1.);
      if (is_ring)
        expect_radius("inner", 0.5);
      if (shape != "disc" && shape != "ring")
        for_each_edge(body, *mesh, "bottom",
                      [](const Vector2 &a, const Vector2 &) { EXPECT_NEAR(a.y(), 0., 1e-12); });
      EXPECT_GT(smallest_jacobian(*mesh, 4), 0.2);
    }
  }
}

TEST(MeshPlaced, RefinedCurvedTopStaysOnItsCurve)
{
  for (const auto &placement : placements)
  {
    auto body = make_body("rectangle with curved top", {2., 1.}, {{4, 2}});
    body.top = Expression("1 + 0.2*x^2*exp(-x)", {}, "test");
    body.placement = placement;
    const auto mesh = make_mesh(body);
    mesh->triangulation.refine_global(1);
    for_each_edge(body, *mesh, "top", [](const Vector2 &a, const Vector2 &) {
      EXPECT_NEAR(a.y(), 1. + 0.2 * a.x() * a.x() * std::exp(-a.x()), 1e-12);
    });
    for_each_edge(body, *mesh, "bottom",
                  [](const Vector2 &a, const Vector2 &) { EXPECT_NEAR(a.y(), 0., 1e-12); });
    const double scale = placement.length_to_world(1.);
    const double exact = 2. + 0.2 * (2. - 10. * std::exp(-2.));
    EXPECT_NEAR(area(*mesh, 3) / (scale * scale), exact, 1e-7);
  }
}

TEST(MeshPlaced, RefinedTrianglesStayStraight)
{
  auto body = make_body("disc", {1.}, {{4, 2}});
  body.cell_type = CellType::triangles;
  body.placement = placements[3];
  const auto mesh = make_mesh(body);
  mesh->triangulation.refine_global(1);
  EXPECT_NEAR(area(*mesh, 1) / 6.25, 8. * std::sin(pi / 8.), 1e-10);
}
