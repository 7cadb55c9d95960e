// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary elements for a smooth field, on polygons that do not depend on the mesh.
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include "bem_orders.h"

using namespace abut;

namespace
{
  const Complex corners[] = {{-.2, .1}, {1., .1}, {1., .8}, {-.2, .8}};

  enum class Support
  {
    clamped, ///< bottom and left
    rollers, ///< the same sides, along their normals
    oblique, ///< the same sides, along directions of their own
    none
  };

  /// A rectangle, 2 n elements by n, turned, with the field in the plane.
  BoundaryCase rectangle_case(const unsigned int n, const Support support, const Degrees &degrees,
                              const double poisson_ratio = .3, const double angle = 0.)
  {
    const Complex turn = std::polar(1., angle);
    BoundaryCase problem;
    problem.material.poisson_ratio = poisson_ratio;
    problem.field = smooth_field(problem.material);
    std::vector<DividedSide> sides;
    for (std::size_t i = 0; i < 4; ++i)
      sides.push_back({corners[i] * turn, uniform(i % 2 == 0 ? 2 * n : n)});
    problem.curves = {divided(sides)};
    problem.supported = [=](const Complex, const Vector2 &normal) -> std::vector<Vector2> {
      const Complex own = Complex(normal.x(), normal.y()) / turn;
      if (support == Support::none || own.real() + own.imag() > 0.)
        return {};
      if (support == Support::clamped)
        return {Vector2::UnitX(), Vector2::UnitY()};
      if (support == Support::rollers)
        return {normal};
      const double direction = own.imag() < -.5 ? 1. : 2.4;
      return {{std::cos(direction), std::sin(direction)}};
    };
    for (const Complex z : {Complex(.4, .45), Complex(.1, .3), Complex(.75, .6), Complex(.8, .3)})
      problem.points.push_back(z * turn);
    problem.displacement_degree = degrees.displacement;
    problem.traction_degree = degrees.traction;
    return problem;
  }

  /// Rollers on two sides between which the boundary turns by an angle.
  BoundaryCase bent_case(const unsigned int n, const double angle, const Degrees &degrees)
  {
    BoundaryCase problem = rectangle_case(n, Support::none, degrees);
    const Complex bend(.5, 0.), end = bend + .7 * std::polar(1., angle);
    problem.curves = {divided({{{-.2, 0.}, uniform(n)},
                               {bend, uniform(n)},
                               {end, uniform(n)},
                               {{end.real(), 1.}, uniform(2 * n)},
                               {{-.2, 1.}, uniform(n)}})};
    problem.supported = [](const Complex, const Vector2 &normal) -> std::vector<Vector2> {
      if (normal.y() > -.1)
        return {};
      return {normal};
    };
    problem.points = {{.1, .5}, {.4, .6}, {.2, .3}};
    return problem;
  }
} // namespace

TEST(BemSmooth, MixedConditionsOnARectangle)
{
  const std::string names[] = {"Clamped", "On rollers", "Held along oblique directions"};
  for (const Degrees &degrees : all_degrees)
    for (const Support support : {Support::clamped, Support::rollers, Support::oblique})
      expect_orders(study(
                        names[static_cast<int>(support)] + name_of(degrees),
                        [&](const unsigned int n) { return rectangle_case(n, support, degrees); }, 2, 5),
                    degrees);
}

TEST(BemSmooth, RollersOnATurnedRectangle)
{
  for (const Degrees &degrees : all_degrees)
    expect_orders(
        study(
            "On rollers, turned" + name_of(degrees),
            [&](const unsigned int n) { return rectangle_case(n, Support::rollers, degrees, .3, .6); }, 2),
        degrees);
}

// Where directions at a vertex were averaged that belong to two sides, orders fell to 0.3.
TEST(BemSmooth, RollersOnBothSidesOfABend)
{
  for (const Degrees &degrees : all_degrees)
    for (const double angle : {20., 40., 50.})
    {
      const bool linear = degrees.displacement == 1 && degrees.traction == 1;
      const ConvergenceTable table = study(
          "On rollers, bent by " + std::to_string(static_cast<int>(angle)) + " degrees" + name_of(degrees),
          [&](const unsigned int n) { return bent_case(n, angle * M_PI / 180., degrees); }, 4,
          linear ? 5 : 4);
      if (!linear)
        expect_orders(table, degrees);
      // Tractions of P1/P1 go through orders of 0.6 to 1.9 on these meshes.
      EXPECT_GT(table.last_rate(displacement), degrees.displacement + .9);
      EXPECT_GT(table.last_rate(stress), degrees.displacement + .9);
    }
}

TEST(BemSmooth, NearlyIncompressible)
{
  for (const Degrees &degrees : all_degrees)
    expect_orders(
        study(
            "Clamped, nu = 0.4999999" + name_of(degrees),
            [&](const unsigned int n) { return rectangle_case(n, Support::clamped, degrees, .4999999); }, 2),
        degrees);
}

TEST(BemSmooth, TractionsAllAround)
{
  for (const Degrees &degrees : all_degrees)
  {
    if (degrees.traction == 0)
      continue; // constant tractions lose the load's balance of moments
    const ConvergenceTable table = study(
        "Tractions all around" + name_of(degrees),
        [&](const unsigned int n) { return rectangle_case(n, Support::none, degrees); }, 2);
    EXPECT_GT(table.last_rate(displacement), degrees.displacement + .9);
    EXPECT_GT(table.last_rate(stress), degrees.displacement + .9);
    EXPECT_EQ(solve(rectangle_case(2, Support::none, degrees)).n_free_rigid_motions, 3);
  }
}

TEST(BemSmooth, RigidMotionsChangeNothingWithoutSupports)
{
  const BoundaryCase original = rectangle_case(4, Support::none, {1, 1});
  BoundaryCase moved = original;
  moved.field.displacement = [=](const Complex z) {
    return original.field.displacement(z) + Complex(.3, -2.) + Complex(0., .7) * z;
  };
  const BoundaryErrors a = solve(original), b = solve(moved);
  EXPECT_NEAR(a.stress, b.stress, 1e-12);
}

TEST(BemSmooth, UnbalancedTractionsAreRefused)
{
  for (const double excess : {1e-8, 1e-4})
  {
    BoundaryCase problem = rectangle_case(16, Support::none, {2, 2});
    const auto traction = problem.field.traction;
    problem.field.traction = [=](const Complex z, const Complex normal) {
      return traction(z, normal) * (normal.real() > .5 ? 1. + excess : 1.);
    };
    if (excess < 1e-6)
    {
      EXPECT_NO_THROW(solve(problem));
    }
    else
    {
      EXPECT_THROW(solve(problem), ComputationError);
    }
  }
}

TEST(BemSmooth, UnitsChangeNoError)
{
  for (const Support support : {Support::clamped, Support::rollers, Support::none})
  {
    const BoundaryCase original = rectangle_case(4, support, {2, 1});
    const BoundaryErrors expected = solve(original);
    for (const double length : {1e-6, 1e6})
      for (const double force_per_area : {1e-9, 2e11})
      {
        const BoundaryErrors errors = solve(in_units(original, length, force_per_area));
        EXPECT_NEAR(errors.displacement, expected.displacement, 1e-9 * expected.displacement);
        EXPECT_NEAR(errors.stress, expected.stress, 1e-9 * expected.stress);
        if (support != Support::none)
        {
          EXPECT_NEAR(errors.traction, expected.traction, 1e-9 * expected.traction);
        }
      }
  }
}
