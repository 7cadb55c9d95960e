// SPDX-License-Identifier: LGPL-2.1-or-later
// Points inside polygons, against areas that are known by a formula.
#include <abut/trace/polygon_area.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace abut;

namespace
{
  using Edge = PolygonArea::Edge;

  std::vector<Edge> closed(const std::vector<Vector2> &corners)
  {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges.push_back({{corners[i], corners[(i + 1) % corners.size()]}});
    return edges;
  }

  std::vector<Edge> circle(const double radius, const unsigned int n)
  {
    std::vector<Vector2> corners;
    for (unsigned int i = 0; i < n; ++i)
      corners.emplace_back(radius * std::cos(2. * M_PI * i / n), radius * std::sin(2. * M_PI * i / n));
    return closed(corners);
  }

  bool any(std::size_t)
  {
    return true;
  }

  /// A ring of the radii 1 and 2, of circles of very different edges.
  PolygonArea ring()
  {
    std::vector<Edge> edges = circle(2., 3000);
    for (const auto &[from, to] : circle(1., 400))
      edges.push_back({{to, from}});
    return PolygonArea(edges);
  }
} // namespace

TEST(PolygonArea, ARingIsAsItsRadiiSay)
{
  const PolygonArea area = ring();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-2.5, 2.5);
  constexpr double chords = 1. - .999969; // what 400 edges of the unit circle are off it
  for (unsigned int i = 0; i < 2000; ++i)
  {
    const Vector2 point(coordinate(random), coordinate(random));
    const double radius = point.norm(), distance = std::min(std::abs(radius - 1.), std::abs(radius - 2.));
    if (distance > chords)
    {
      EXPECT_EQ(area.contains(point), radius > 1. && radius < 2.) << radius;
    }
    EXPECT_NEAR(area.nearest(point, any)->distance, distance, chords) << radius;
  }
}

TEST(PolygonArea, TheNearestIsThatOfAllEdges)
{
  const std::vector<Edge> edges = closed({{0., 0.}, {7., 0.}, {7., .2}, {3., .2}, {3., .1}, {0., .1}});
  const PolygonArea area(edges);
  EXPECT_TRUE(area.contains({5., .15}));
  EXPECT_FALSE(area.contains({1., .15}));
  EXPECT_EQ(area.nearest({1., .15}, any)->edge, 4u);
  EXPECT_NEAR(area.nearest({1., .15}, any)->distance, .05, 1e-15);
  const auto left = area.nearest({100., 3.}, [](const std::size_t k) { return k == 5; });
  EXPECT_NEAR(left->distance, std::hypot(100., 2.9), 1e-12);
  EXPECT_FALSE(area.nearest({0., 0.}, [](std::size_t) { return false; }));
}

TEST(PolygonArea, ALineCrossesWhereItIsMet)
{
  const std::vector<double> shares = ring().crossings({{Vector2(-3., 0.), Vector2(3., 1e-3)}});
  ASSERT_EQ(shares.size(), 4u);
  const std::array<double, 4> places = {{-2., -1., 1., 2.}};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(-3. + 6. * shares[i], places[i], 1e-4);
  EXPECT_TRUE(ring().crossings({{Vector2(-.5, 0.), Vector2(.5, .3)}}).empty());
}
