// SPDX-License-Identifier: LGPL-2.1-or-later
// Piecewise constant multipliers: balance of forces and moments, means of gaps and displacements.
#include <gtest/gtest.h>

#include "surface_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  Eigen::VectorXd random_pressures(const Index n)
  {
    std::srand(7);
    return Eigen::VectorXd::Random(n);
  }

  Vector2 resultant(const Eigen::VectorXd &forces)
  {
    Vector2 sum = Vector2::Zero();
    for (Index i = 0; i < forces.size(); i += 2)
      sum += forces.segment<2>(i);
    return sum;
  }

  double moment(const Eigen::VectorXd &forces, const Trace &trace)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < trace.n_nodes(); ++i)
    {
      const Vector2 f = forces.segment<2>(static_cast<Index>(2 * i)), x = trace.node_points()[i];
      sum += x.x() * f.y() - x.y() * f.x();
    }
    return sum;
  }

  void expect_balance(const Trace &cut, const Trace &other, const bool with_moments)
  {
    const Coupling coupling = TestSurface(cut, other).couple();
    const Eigen::VectorXd p = random_pressures(coupling.weights.size());
    const Eigen::VectorXd on_cut = coupling.cut[normal_direction].transpose() * p,
                          on_other = coupling.other[normal_direction].transpose() * p;
    EXPECT_GT(on_cut.norm(), .01);
    EXPECT_LT((resultant(on_cut) + resultant(on_other)).norm(), 1e-13);
    if (with_moments)
    {
      EXPECT_NEAR(moment(on_cut, cut) + moment(on_other, other), 0., 1e-13);
    }
  }
} // namespace

TEST(TraceCoupling, WeightsAreTheLengthsOfTheParts)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const TestSurface surface(make_line(3., 0., 1., 5, degree), make_line(0., 3., 1., 7, degree));
    const Coupling coupling = surface.couple();
    EXPECT_NEAR(coupling.covered_length, 3., 1e-14);
    for (std::size_t k = 0; k < surface.parts().size(); ++k)
      EXPECT_NEAR(coupling.weights[static_cast<Index>(k)], surface.parts()[k].length, 1e-14);
  }
  EXPECT_NEAR(TestSurface(make_arc(1., 1., 0., 9, 2), make_arc(1.1, -.2, 1.3, 11, 2)).couple().covered_length,
              1., 1e-8);
}

TEST(TraceCoupling, ForcesAndMomentsBalanceOnStraightSides)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    expect_balance(make_line(3., 0., 1., 5, degree), make_line(0., 3., 1.3, 7, 2), true);
    expect_balance(make_line(3., 0., 1., 5, degree), make_line(.7, 2.2, .9, 7, 1), true);
    const auto inclined = [](const double x) { return Vector2(x, 1.2 + .1 * x); };
    expect_balance(make_line(3., 0., 1., 5, degree), make_curve(inclined, parameters(-.5, 3.5, 4), 1, 1),
                   true);
  }
}

TEST(TraceCoupling, ForcesBalanceOnCurvedSides)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    expect_balance(make_arc(1., 0., 1.5, 7, degree), make_arc(1.2, 1.5, 0., 5, degree), false);
    expect_balance(make_arc(1., 0., 2. * M_PI, 20, degree), make_arc(.95, 2. * M_PI, 0., 28, degree), false);
    // Moments are taken at nodes: they show the whole truth where the space has the geometry's degree.
    expect_balance(make_arc(1., 0., 1.5, 7, degree, degree), make_arc(1.2, 1.6, -.1, 5, degree, degree),
                   true);
  }
}

TEST(TraceCoupling, GapsAreMeansOverTheParts)
{
  const auto linear = [](const Vector2 &x, const Opposite &) { return .3 - .2 * x.x(); };
  const auto inclined = [](const double x) { return Vector2(x, 1.3 - .2 * x); };
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const TestSurface surface(make_line(3., 0., 1., 5, degree),
                              make_curve(inclined, parameters(-.1, 3.1, 7), 1, 1));
    const Coupling coupling = surface.couple(linear);
    for (std::size_t k = 0; k < surface.parts().size(); ++k)
    {
      const auto i = static_cast<Index>(k);
      EXPECT_NEAR(coupling.gap[i] / coupling.weights[i], .3 - .2 * surface.parts()[k].middle.x(), 1e-14);
    }
    for (const double gap : {coupling.smallest_gap, surface.couple().smallest_gap})
    {
      EXPECT_LT(gap, -.28);
      EXPECT_GE(gap, -.3 - 1e-14);
    }
    EXPECT_GT(coupling.largest_gap, .28);
    EXPECT_LE(coupling.largest_gap, .3);
  }
}

TEST(TraceCoupling, MeanGapsAreNeverBelowTheSmallestGap)
{
  // Multipliers that are not negative do not extrapolate: bodies that are apart everywhere do not press,
  // whatever is covered.
  const auto corner = [](const double r) -> Vector2 { return Vector2(r, .02 + std::abs(r)); };
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const double end : {.707, .2, .01, 1e-6})
    {
      const Trace block = make_line(1.5, -1.5, 0., 3, degree);
      const Trace square = make_curve(corner, parameters(0., end, 2), degree, 1);
      for (const bool block_is_cut : {true, false})
      {
        const Coupling coupling =
            block_is_cut ? TestSurface(block, square).couple() : TestSurface(square, block).couple();
        EXPECT_GE(coupling.gap.cwiseQuotient(coupling.weights).minCoeff(), .02 - 1e-12)
            << degree << ' ' << end;
      }
    }
}

TEST(TraceCoupling, RigidAndLinearDisplacementsChangeTheGapAsTheyShould)
{
  // u_c = (0, a + b x) and u_o = (0, c + d x): the gap grows by u_o - u_c, for any meshes.
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const Trace cut = make_line(3., 0., 1., 5, degree), other = make_line(0., 3., 1., 7, 1);
    const TestSurface surface(cut, other);
    const Coupling coupling = surface.couple();
    const auto displacement = [](const Trace &trace, const double at_zero, const double slope) {
      Eigen::VectorXd u = Eigen::VectorXd::Ones(static_cast<Index>(2 * trace.n_nodes()));
      for (std::size_t i = 0; i < trace.n_nodes(); ++i)
        u[static_cast<Index>(2 * i + 1)] = at_zero + slope * trace.node_points()[i].x();
      return u;
    };
    const Eigen::VectorXd change = coupling.cut[normal_direction] * displacement(cut, .5, -2.) +
                                   coupling.other[normal_direction] * displacement(other, .1, 3.);
    for (Index i = 0; i < change.size(); ++i)
      EXPECT_NEAR(change[i] / coupling.weights[i],
                  -.4 + 5. * surface.parts()[static_cast<std::size_t>(i)].middle.x(), 1e-12);
  }
}
