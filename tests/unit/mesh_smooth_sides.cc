// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth curve through the vertices of a boundary.
#include <abut/mesh/smooth_sides.h>

#include "mesh_testing.h"

using namespace abut;

namespace
{
  /// The edges of a polygon, all of one side.
  RawMesh polygon(const std::vector<Vector2> &vertices)
  {
    RawMesh mesh;
    mesh.vertices = vertices;
    const auto n = static_cast<unsigned int>(vertices.size());
    for (unsigned int i = 0; i < n; ++i)
      mesh.boundary_edges.push_back({{{i, (i + 1) % n}}, 1});
    return mesh;
  }

  std::vector<Vector2> on_circle(const std::vector<double> &degrees, const double radius)
  {
    std::vector<Vector2> points;
    for (const double angle : degrees)
      points.emplace_back(radius * std::cos(angle * pi / 180.), radius * std::sin(angle * pi / 180.));
    return points;
  }

  double largest_distance(const RawMesh &mesh, const double radius)
  {
    double largest = 0.;
    for (const auto &edge : mesh.boundary_edges)
      for (const Vector2 &point : edge.curve)
        largest = std::max(largest, std::abs(point.norm() - radius));
    return largest;
  }

  constexpr double corner_angle = .35; // 20 degrees
} // namespace

TEST(SmoothSides, ArcsComeOutAsArcs)
{
  std::vector<double> even, uneven;
  for (int i = 0; i < 32; ++i)
  {
    even.push_back(11.25 * i);
    uneven.push_back(11.25 * i + 3. * std::sin(2. * i));
  }
  for (const auto &degrees : {even, uneven})
  {
    RawMesh mesh = polygon(on_circle(degrees, 3.));
    smooth_sides(mesh, {}, corner_angle);
    for (const auto &edge : mesh.boundary_edges)
      ASSERT_EQ(edge.curve.size(), 4u);
    // A cubic misses an arc of angle a by 4/27 (a/4)^6 of the radius; edges of 15 degrees here at most.
    EXPECT_LT(largest_distance(mesh, 3.), 3. * 4. / 27. * std::pow(17. / 4. * pi / 180., 6));
  }
}

TEST(SmoothSides, ArcsThatEndAtCornersToo)
{
  std::vector<double> degrees;
  for (int i = 0; i <= 12; ++i)
    degrees.push_back(15. * i);
  RawMesh mesh = polygon(on_circle(degrees, 1.)); // a half disc: the last edge is its diameter
  smooth_sides(mesh, {}, corner_angle);
  EXPECT_TRUE(mesh.boundary_edges.back().curve.empty());
  mesh.boundary_edges.pop_back();
  EXPECT_LT(largest_distance(mesh, 1.), 4. / 27. * std::pow(15. / 4. * pi / 180., 6));
}

TEST(SmoothSides, StraightRunsStayStraightWhereAnArcBegins)
{
  // A slot: two straight edges, a half circle in ten, two straight edges, a flat end.
  std::vector<Vector2> points = {{2., -1.}, {1., -1.}};
  for (int i = 0; i <= 10; ++i)
    points.emplace_back(-std::sin(pi * i / 10.), -std::cos(pi * i / 10.));
  points.emplace_back(1., 1.);
  points.emplace_back(2., 1.);
  std::reverse(points.begin(), points.end());
  RawMesh mesh = polygon(points);
  smooth_sides(mesh, {}, corner_angle);
  for (const auto &edge : mesh.boundary_edges)
  {
    const bool on_arc = std::max(points[edge.vertices[0]].x(), points[edge.vertices[1]].x()) < 1e-12;
    EXPECT_EQ(edge.curve.empty(), !on_arc);
    for (const Vector2 &point : edge.curve)
      EXPECT_NEAR(point.norm(), 1., 1e-6);
  }
}

TEST(SmoothSides, AFlatOfOneEdgeBetweenArcsStaysStraight)
{
  // A stadium; the flats as long as an edge of the arcs, and much longer.
  for (const double length : {.314, 3.})
  {
    std::vector<Vector2> points;
    for (int i = 0; i <= 10; ++i)
      points.emplace_back(.5 * length + std::sin(pi * i / 10.), -std::cos(pi * i / 10.));
    for (int i = 0; i <= 10; ++i)
      points.emplace_back(-.5 * length - std::sin(pi * i / 10.), std::cos(pi * i / 10.));
    RawMesh mesh = polygon(points);
    smooth_sides(mesh, {}, corner_angle);
    for (const auto &edge : mesh.boundary_edges)
    {
      const bool is_flat = points[edge.vertices[0]].x() * points[edge.vertices[1]].x() < 0.;
      EXPECT_EQ(edge.curve.empty(), is_flat) << length;
      for (const Vector2 &point : edge.curve)
        EXPECT_NEAR((point - Vector2(std::copysign(.5 * length, point.x()), 0.)).norm(), 1., 1e-6);
    }
  }
}

TEST(SmoothSides, PolygonsAndBluntCornersBetweenStraightRunsStay)
{
  const double slope = std::tan(10. * pi / 180.);
  for (const std::vector<Vector2> &points :
       {std::vector<Vector2>{{0., 0.}, {1., 0.}, {2., 0.}, {2., 1.}, {0., 1.}},
        std::vector<Vector2>{{0., 0.}, {1., 0.}, {2., 0.}, {3., slope}, {4., 2. * slope}, {0., 5.}}})
  {
    RawMesh mesh = polygon(points);
    smooth_sides(mesh, {}, corner_angle);
    for (const auto &edge : mesh.boundary_edges)
      EXPECT_TRUE(edge.curve.empty());
  }
}

TEST(SmoothSides, ACurveEndsWhereItsSideEnds)
{
  std::vector<double> degrees;
  for (int i = 0; i < 36; ++i)
    degrees.push_back(10. * i);
  RawMesh mesh = polygon(on_circle(degrees, 1.));
  for (std::size_t i = 9; i < 36; ++i)
    mesh.boundary_edges[i].side = 2;
  // Move a point of the other side: the first side does not feel it.
  mesh.vertices[10] *= 1.02;
  smooth_sides(mesh, {}, corner_angle);
  for (std::size_t i = 0; i < 9; ++i)
    for (const Vector2 &point : mesh.boundary_edges[i].curve)
      EXPECT_NEAR(point.norm(), 1., 1e-8);
}
