// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas, sides and cells of the built-in shapes, in their own frames.
#include <abut/scene/shape_entry.h>

#include "mesh_testing.h"
#include <algorithm>
#include <cmath>

using namespace abut;

namespace
{

  struct Expected
  {
    std::string shape;
    std::vector<double> size;
    std::array<unsigned int, 2> cells;
    unsigned int n_cells;
    double area;
    std::map<std::string, double> lengths;
  };

  const std::vector<Expected> shapes = {
      {"rectangle",
       {4., 1.5},
       {{5, 3}},
       15,
       6.,
       {{"left", 1.5}, {"right", 1.5}, {"bottom", 4.}, {"top", 4.}}},
      {"L-shape",
       {2.},
       {{3, 2}},
       18,
       12.,
       {{"left", 4.}, {"right", 2.}, {"bottom", 2.}, {"top", 4.}, {"corner", 4.}}},
      {"disc", {2.}, {{6, 3}}, 4 * (9 + 18), 4. * pi, {{"outer", 4. * pi}}},
      {"half disc", {2.}, {{6, 3}}, 2 * (9 + 18), 2. * pi, {{"outer", 2. * pi}, {"bottom", 4.}}},
      {"quarter disc", {2.}, {{6, 3}}, 9 + 18, pi, {{"outer", pi}, {"left", 2.}, {"bottom", 2.}}},
      {"ring", {1., 3.}, {{5, 2}}, 40, 8. * pi, {{"inner", 2. * pi}, {"outer", 6. * pi}}},
      {"quarter ring",
       {1., 3.},
       {{5, 2}},
       10,
       2. * pi,
       {{"inner", pi / 2.}, {"outer", 1.5 * pi}, {"left", 2.}, {"bottom", 2.}}}};
} // namespace

TEST(MeshShapes, AreasSidesAndCells)
{
  for (const auto &expected : shapes)
  {
    SCOPED_TRACE(expected.shape);
    const auto mesh = make_mesh(make_body(expected.shape, expected.size, expected.cells));
    EXPECT_EQ(mesh->triangulation.n_active_cells(), expected.n_cells);
    EXPECT_EQ(mesh->curved, Registry<ShapeEntry>::get().find(expected.shape).has_curves);
    EXPECT_NEAR(area(*mesh, 4), expected.area, 1e-6 * expected.area);
    EXPECT_EQ(mesh->boundaries.size(), expected.lengths.size());
    for (const auto &[side, length] : expected.lengths)
      EXPECT_NEAR(side_length(*mesh, side, 4), length, 1e-6 * length) << side;
    expect_all_sides_named(*mesh);
  }
}

TEST(MeshShapes, RectangleIsExact)
{
  auto body = make_body("rectangle", {4., 1.5}, {{5, 3}});
  body.grading = {{3., 0.25}};
  const auto mesh = make_mesh(body);
  EXPECT_NEAR(area(*mesh, 1), 6., 1e-13);
  for (const auto &[side, length] : std::map<std::string, double>{{"left", 1.5}, {"top", 4.}})
    EXPECT_NEAR(side_length(*mesh, side, 1), length, 1e-13);
}

TEST(MeshShapes, GradingIsGeometric)
{
  auto body = make_body("rectangle", {7., 1.}, {{3, 1}});
  body.grading = {{4., 1.}};
  std::vector<double> lengths;
  const auto mesh = make_mesh(body);
  for_each_edge(body, *mesh, "top",
                [&](const Vector2 &a, const Vector2 &b) { lengths.push_back((a - b).norm()); });
  std::sort(lengths.begin(), lengths.end());
  ASSERT_EQ(lengths.size(), 3u);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(lengths[static_cast<std::size_t>(i)], std::pow(2., i), 1e-14);
}

TEST(MeshShapes, DegreeOneDiscIsAPolygon)
{
  const auto mesh = make_mesh(make_body("disc", {2.}, {{4, 2}}));
  EXPECT_NEAR(area(*mesh, 1), 32. * std::sin(pi / 8.), 1e-13);
}

TEST(MeshShapes, AreaOfADiscConverges)
{
  for (unsigned int degree = 1; degree <= 2; ++degree)
  {
    const auto error = [&](unsigned int n) {
      return std::abs(area(*make_mesh(make_body("disc", {1.}, {{n, n / 2}})), degree) - pi);
    };
    EXPECT_NEAR(std::log2(error(8) / error(16)), 2. * degree, 0.05);
  }
}

TEST(MeshShapes, CellsOfDiscsAndRingsAreValidForEveryDegree)
{
  for (const std::string shape : {"disc", "half disc", "quarter disc", "ring"})
    for (const unsigned int n : {2u, 4u, 10u})
      for (unsigned int refinements = 0; refinements < 3; ++refinements)
      {
        const auto mesh = make_mesh(make_body(shape, {1., 1.5}, {{n, 1 + n / 4}}));
        mesh->triangulation.refine_global(refinements);
        for (unsigned int degree = 1; degree <= 4; ++degree)
          EXPECT_GT(smallest_jacobian(*mesh, degree), 0.2) << shape << ' ' << n << ' ' << degree;
      }
}

TEST(MeshShapes, CurvedTop)
{
  auto body = make_body("rectangle with curved top", {2., 1.}, {{8, 3}});
  body.top = Expression("1 + a*sin(3*x)", {{"a", 0.2}}, "test");
  const auto mesh = make_mesh(body);
  EXPECT_TRUE(mesh->curved);
  const double exact = 2. + 0.2 * (1. - std::cos(6.)) / 3.;
  EXPECT_NEAR(area(*mesh, 4), exact, 1e-6);
  EXPECT_NEAR(side_length(*mesh, "left", 4), 1., 1e-14);
  EXPECT_NEAR(side_length(*mesh, "right", 4), 1. + 0.2 * std::sin(6.), 1e-14);
  expect_all_sides_named(*mesh);
}

TEST(MeshShapes, Triangles)
{
  auto body = make_body("rectangle", {4., 1.5}, {{5, 3}});
  body.cell_type = CellType::triangles;
  const auto rectangle = make_mesh(body);
  EXPECT_EQ(rectangle->cell_type, CellType::triangles);
  EXPECT_EQ(rectangle->triangulation.n_active_cells(), 30u);
  EXPECT_TRUE(rectangle->triangulation.all_reference_cells_are_simplex());
  EXPECT_NEAR(area(*rectangle, 1), 6., 1e-13);
  EXPECT_NEAR(side_length(*rectangle, "right", 1), 1.5, 1e-14);
  expect_all_sides_named(*rectangle);

  body = make_body("disc", {2.}, {{4, 2}});
  body.cell_type = CellType::triangles;
  const auto disc = make_mesh(body);
  EXPECT_FALSE(disc->curved);
  EXPECT_NEAR(area(*disc, 1), 32. * std::sin(pi / 8.), 1e-13);
  expect_all_sides_named(*disc);
}

TEST(MeshShapes, WrongCellsAndTopsAreRefused)
{
  const auto make = [](const BodyDescription &body) { return [=] { make_mesh(body); }; };
  expect_refused(make(make_body("rectangle", {1., 1.}, {{0, 3}})), "Body block/Cells: 0, 3");
  expect_refused(make(make_body("disc", {1.}, {{3, 3}})), "even");

  auto body = make_body("rectangle with curved top", {2., 1.}, {{8, 3}});
  body.top = Expression("1 - x", {}, "test");
  expect_refused(make(body), "Body block/Top");
}
