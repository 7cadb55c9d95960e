// SPDX-License-Identifier: LGPL-2.1-or-later
// The mixed boundary value problem: linear fields, which boundary elements hold exactly, with every mix of
// conditions; free rigid motions; loads that are not balanced.
#include <abut/base/user_error.h>

#include <gtest/gtest.h>

#include "../convergence/bem_study.h"
#include <string>

using namespace abut;

namespace
{
  using Directions = std::vector<Vector2>;
  const Directions both = {Vector2::UnitX(), Vector2::UnitY()};

  struct NamedBody
  {
    std::string name;
    std::vector<Curve> curves;
    Complex inside;
  };

  std::vector<NamedBody> bodies()
  {
    const std::vector<double> parts = {0., .1, .35, .7};
    const Curve rectangle =
                    divided({{{-.2, .1}, parts}, {{1., .1}, parts}, {{1., .8}, parts}, {{-.2, .8}, parts}}),
                hole = divided({{{.3, .3}, {0., .4}}, {{.3, .6}, {0., .5}}, {{.7, .4}, {0.}}}),
                notched = divided({{{0., 0.}, parts},
                                   {{1., 0.}, parts},
                                   {{1., .4}, parts},
                                   {{.5, .4}, parts},
                                   {{.5, .9}, parts},
                                   {{0., .9}, parts}});
    return {{"rectangle", {rectangle}, {.1, .5}},
            {"rectangle with a hole", {rectangle, hole}, {.1, .5}},
            {"L", {notched}, {.3, .3}},
            {"disc", {regular_polygon(16, .7)}, {.1, .2}}};
  }

  struct NamedSupport
  {
    std::string name;
    std::function<Directions(Complex, Vector2)> supported;
    Eigen::Index n_free_rigid_motions;
  };

  /// Where a straight side faces; round ones in parts.
  bool faces(const Vector2 &normal, const Vector2 &direction)
  {
    return normal.dot(direction) > .75;
  }

  const std::vector<NamedSupport> supports = {
      {"none", [](Complex, const Vector2 &) { return Directions(); }, 3},
      {"all", [](Complex, const Vector2 &) { return both; }, 0},
      {"clamped below",
       [](Complex, const Vector2 &n) { return faces(n, -Vector2::UnitY()) ? both : Directions(); }, 0},
      {"roller below",
       [](Complex, const Vector2 &n) {
         return faces(n, -Vector2::UnitY()) ? Directions{Vector2::UnitY()} : Directions();
       },
       1},
      {"oblique below",
       [](Complex, const Vector2 &n) {
         return faces(n, -Vector2::UnitY()) ? Directions{{.6, .8}} : Directions();
       },
       1},
      {"rollers below and on the left",
       [](Complex, const Vector2 &n) {
         return faces(n, -Vector2::UnitY())   ? Directions{Vector2::UnitY()}
                : faces(n, -Vector2::UnitX()) ? Directions{Vector2::UnitX()}
                                              : Directions();
       },
       0},
      {"in x everywhere", [](Complex, const Vector2 &) { return Directions{Vector2::UnitX()}; }, 1},
      {"clamped for x < 0.1, roller above",
       [](const Complex z, const Vector2 &n) {
         return z.real() < .1                ? both
                : faces(n, Vector2::UnitY()) ? Directions{Vector2::UnitY()}
                                             : Directions();
       },
       0}};

  BoundaryCase linear_case(const NamedBody &body, const NamedSupport &support, const double poisson_ratio)
  {
    BoundaryCase problem;
    problem.material.poisson_ratio = poisson_ratio;
    problem.field = linear_field(problem.material);
    problem.curves = body.curves;
    problem.supported = support.supported;
    problem.points = {body.inside};
    return problem;
  }
} // namespace

TEST(BemProblem, IsExactForLinearFields)
{
  struct Degrees
  {
    unsigned int displacement, traction;
  };
  for (const NamedBody &body : bodies())
    for (const NamedSupport &support : supports)
      for (const double nu : {0., .3, .4999999})
        for (const Degrees degrees : {Degrees{1, 0}, Degrees{1, 1}, Degrees{2, 1}, Degrees{3, 2}})
        {
          SCOPED_TRACE(body.name + ", " + support.name);
          BoundaryCase problem = linear_case(body, support, nu);
          problem.displacement_degree = degrees.displacement;
          problem.traction_degree = degrees.traction;
          const BoundaryErrors errors = solve(problem);
          const std::string name = body.name + ", " + support.name + ", " + std::to_string(nu) + ", P" +
                                   std::to_string(degrees.displacement) + "/P" +
                                   std::to_string(degrees.traction);
          // Where nothing can give way, round-off of div u becomes pressure.
          const double tolerance = support.name == "all" ? 1e-10 + 1e-15 / (1. - 2. * nu) : 1e-10;
          EXPECT_EQ(errors.n_free_rigid_motions, support.n_free_rigid_motions) << name;
          EXPECT_LT(errors.displacement, 1e-10) << name;
          EXPECT_LT(errors.stress, tolerance) << name;
          if (support.name != "none")
          {
            EXPECT_LT(errors.traction, tolerance) << name;
          }
        }
}

TEST(BemProblem, IsAsExactAsTheEstimatingRule)
{
  double largest = 0.;
  for (const NamedBody &body : bodies())
    for (const NamedSupport &support : supports)
    {
      SCOPED_TRACE(body.name + ", " + support.name);
      BoundaryCase problem = linear_case(body, support, .3);
      problem.rule = GalerkinRule::estimating();
      const BoundaryErrors errors = solve(problem);
      EXPECT_LT(errors.displacement, 1e-4);
      EXPECT_LT(errors.stress, 1e-4);
      largest = std::max(largest, errors.stress);
    }
  EXPECT_GT(largest, 1e-9);
}

TEST(BemProblem, RefusesLoadsThatAreNotBalanced)
{
  const NamedBody body = bodies().front();
  for (const NamedSupport &support : supports)
    for (const bool turning : {false, true})
    {
      BoundaryCase problem = linear_case(body, support, .3);
      // A force in x on the right side, or a couple of it.
      problem.field.traction = [&](const Complex z, const Complex normal) -> Complex {
        return normal.real() < .75 ? 0. : turning ? z.imag() - .45 : 1.;
      };
      // In x: `none`, and rollers along y; about a rotation: what prevents none.
      const bool moves = support.name == "none" || (support.name == "roller below" && !turning) ||
                         (support.name == "oblique below" && !turning);
      if (moves)
      {
        EXPECT_THROW(solve(problem), ComputationError) << support.name << turning;
      }
      else
      {
        EXPECT_NO_THROW(solve(problem)) << support.name << turning;
      }
    }
}
