// SPDX-License-Identifier: LGPL-2.1-or-later
// Interior stress of whole bodies from the exact values of a field on their boundary.
#include <gtest/gtest.h>

#include "bem_exact_field.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using namespace abut;

namespace
{
  struct Body
  {
    std::string name;
    std::vector<BoundaryElement> elements;
  };

  std::vector<Complex> turned(std::vector<Complex> corners)
  {
    for (Complex &corner : corners)
      corner = Complex(.05, .02) + corner * std::polar(1., .3);
    return corners;
  }

  const std::vector<Complex> rectangle = {{0., 0.}, {.9, 0.}, {.9, .6}, {0., .6}};
  const std::vector<Complex> l_shape = {{0., -.5}, {.6, -.5}, {.6, .4}, {-.6, .4}, {-.6, 0.}, {0., 0.}};

  std::vector<Body> bodies()
  {
    std::vector<Body> bodies = {{"rectangle", divided_polygon(turned(rectangle), uniform_places(30))},
                                {"graded by 1e4", divided_polygon(rectangle, graded_places(11, 2.512))},
                                {"graded L", divided_polygon(l_shape, graded_places(9, 2.))},
                                {"hole", divided_polygon(turned(rectangle), uniform_places(7))}};
    const std::vector<Complex> clockwise = turned({{.3, .2}, {.4, .4}, {.6, .3}});
    for (const BoundaryElement &element : divided_polygon(clockwise, graded_places(5, 1.7)))
      bodies.back().elements.push_back(element);
    return bodies;
  }

  /// Whether doubles can tell z, at this distance, from the boundary.
  bool is_clear(const Complex z, const double distance)
  {
    return distance > 16. * std::numeric_limits<double>::epsilon() * std::abs(z);
  }

  /// Points 0.1 to 1e-12 lengths inside of every element, and on the bisectors of every corner and node.
  std::vector<Complex> points_near_boundary(const std::vector<BoundaryElement> &elements)
  {
    std::vector<Complex> points;
    const auto add = [&](const Complex foot, const Complex inwards, const double distance) {
      const Complex z = foot + distance * inwards;
      if (is_clear(z, distance))
        points.push_back(z);
    };
    for (const BoundaryElement &element : elements)
      for (int power = 1; power <= 12; ++power)
      {
        const double distance = std::pow(10., -power) * element.length;
        const Complex left(0., 1.);
        for (const double eta : {-.9999, -.8, 0., .31, .999})
          add(element.point(eta), left * element.direction, distance);
        for (const BoundaryElement &next : elements)
          if (next.start == element.end)
          {
            const Complex sum = element.direction + next.direction;
            add(element.end, left * sum / std::abs(sum),
                std::min(distance, distance / element.length * next.length));
          }
      }
    return points;
  }

  /// The largest error at the points, relative to the largest value on the boundary.
  double largest_error(const ExactField &field, const std::vector<BoundaryElement> &elements,
                       const std::vector<Complex> &points)
  {
    const InteriorStress interior(elements, field.values(elements), field.shear_modulus, field.poisson_ratio);
    const std::vector<Stress> stresses = interior.at(points);
    double largest = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      largest = std::max(largest, stress_distance(stresses[i], field.stress(points[i])));
    return largest / field.scale(elements);
  }

  std::vector<ExactField> fields()
  {
    std::vector<ExactField> fields;
    for (const double young : {1., 2.1e5})
      for (const double nu : {.3, .4999999})
        fields.push_back({young / (2. + 2. * nu), nu});
    return fields;
  }

  // Sums of some hundred terms, rounded in the 16th digit of the largest value on the boundary.
  constexpr double rounding = 1e-14;

  /// Coefficients P_n of rounded samples are off by (2n+1) unit roundoffs. The jumps that makes at nodes
  /// have a stress of 2/pi ln(1e13) times their size at the closest points.
  double rounded_jumps(const unsigned int degree)
  {
    return (degree + 1.) * (degree + 1.) * .5 * std::numeric_limits<double>::epsilon() * 19.;
  }
} // namespace

TEST(BemStressBody, IsExactUpToTheBoundary)
{
  for (const Body &body : bodies())
  {
    const std::vector<Complex> points = points_near_boundary(body.elements);
    EXPECT_GT(points.size(), 40 * body.elements.size()) << body.name;
    for (const ExactField &field : fields())
      EXPECT_LT(largest_error(field, body.elements, points), rounding)
          << body.name << " " << field.shear_modulus << " " << field.poisson_ratio;
  }
}

TEST(BemStressBody, IsExactForValuesOfAnyDegree)
{
  for (const Body &body : bodies())
  {
    const std::vector<Complex> points = points_near_boundary(body.elements);
    for (unsigned int degree = 0; degree <= max_density_degree; ++degree)
      EXPECT_LT(largest_error({.8, .3, 0., degree}, body.elements, points), rounding + rounded_jumps(degree))
          << body.name << " " << degree;
  }
}

TEST(BemStressBody, DoesNotFeelARotation)
{
  for (const Body &body : bodies())
    for (ExactField field : fields())
    {
      field.rotation = 3. / field.shear_modulus; // slopes as large as those of the strain
      EXPECT_LT(largest_error(field, body.elements, points_near_boundary(body.elements)), rounding)
          << body.name;
    }
}

TEST(BemStressBody, IsZeroOutside)
{
  const std::vector<Complex> outside = turned({{-.01, .3}, {.2, .601}, {4., 3.}, {1e4, 0.}, {.43, .3}});
  const ExactField field{.8, .3, .1};
  const std::vector<BoundaryElement> elements = bodies().back().elements;
  const InteriorStress interior(elements, field.values(elements), field.shear_modulus, field.poisson_ratio);
  for (const Stress &stress : interior.at(outside))
    EXPECT_LT(stress_distance(stress, Stress()), rounding * field.scale(elements));
}

TEST(BemStressBody, IsZeroBesideTinyBodiesFarApart)
{
  // All in one group, whose radius is a million lengths.
  std::vector<BoundaryElement> elements;
  for (const Complex place : {Complex(0., 0.), Complex(1., 1.)})
    for (const BoundaryElement &side : divided_polygon({{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}}, {0., 1.}))
      elements.emplace_back(place + 1e-6 * side.start, place + 1e-6 * side.end);
  const ExactField field{.8, .3};
  const InteriorStress interior(elements, field.values(elements), field.shear_modulus, field.poisson_ratio);
  for (const double distance : {3., 6., 10., 40., 1e3})
  {
    const Complex z = Complex(1., 1.) + 1e-6 * distance * Complex(1., .9);
    EXPECT_LT(stress_distance(interior.at(z), Stress()), rounding * field.scale(elements)) << distance;
  }
}

TEST(BemStressBody, TakesElementsInAnyOrder)
{
  std::vector<BoundaryElement> elements = divided_polygon(rectangle, graded_places(11, 2.512));
  const std::vector<Complex> points = points_near_boundary(elements);
  std::shuffle(elements.begin(), elements.end(), std::mt19937(5));
  EXPECT_LT(largest_error({.8, .3}, elements, points), rounding);
}

TEST(BemStressBody, IsTheSameToTheLastBitOnSeveralThreads)
{
  const std::vector<BoundaryElement> elements = divided_polygon(turned(rectangle), uniform_places(80));
  const ExactField field{.8, .3};
  const InteriorStress interior(elements, field.values(elements), field.shear_modulus, field.poisson_ratio);
  std::vector<Complex> points;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 101; ++j)
      points.emplace_back(.0089 * (i + .5), .0059 * (j + .5));
  points = turned(points);

  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::vector<Stress> one_by_one;
  for (const Complex z : points)
    one_by_one.push_back(interior.at(z));
  const auto middle = Clock::now();
  const std::vector<Stress> together = interior.at(points);
  const std::chrono::duration<double> serial = middle - begin, parallel = Clock::now() - middle;
  ASSERT_EQ(together.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(stress_distance(together[i], one_by_one[i]), 0.);
  std::cout << "one by one " << 1e9 * serial.count() / double(points.size() * elements.size())
            << " ns per point and element, " << serial.count() / parallel.count()
            << " times as fast together\n";
}

TEST(BemStressBody, FollowsOnTheBoundaryFromTractionAndSlope)
{
  for (ExactField field : fields())
    for (const double angle : {0., .7, 1.6, 3.3, 5.})
    {
      field.rotation = 3. / field.shear_modulus;
      const Complex z(.3, .2), direction = std::polar(1., angle);
      const Complex t = field.traction(z, direction), g = field.slope(z, direction);
      const Stress stress = boundary_stress(t, g, direction, field.shear_modulus, field.poisson_ratio);
      EXPECT_LT(stress_distance(stress, field.stress(z)), 10. * rounding) << angle;
    }
}
