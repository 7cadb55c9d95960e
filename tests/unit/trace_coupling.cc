// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multipliers: duality, balance of forces and moments, linear gaps, partial cover.
#include <abut/trace/mortar_coupling.h>

#include <gtest/gtest.h>

#include "trace_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  MortarCoupling couple(const Trace &slave, const Trace &master, const GapFunction &gap)
  {
    return abut::couple(slave, master, common_refinement(slave, master), gap);
  }

  double geometric(const Vector2 &, const double gap)
  {
    return gap;
  }

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

  void expect_balance(const Trace &slave, const Trace &master, const bool with_moments)
  {
    const MortarCoupling coupling = couple(slave, master, geometric);
    const Eigen::VectorXd p = random_pressures(coupling.weights.size());
    const Eigen::VectorXd on_slave = coupling.slave.transpose() * p,
                          on_master = coupling.master.transpose() * p;
    EXPECT_GT(on_slave.norm(), .01);
    EXPECT_LT((resultant(on_slave) + resultant(on_master)).norm(), 1e-13);
    if (with_moments)
    {
      EXPECT_NEAR(moment(on_slave, slave) + moment(on_master, master), 0., 1e-13);
    }
  }
} // namespace

TEST(TraceCoupling, MultipliersAreDualToTheShapeFunctions)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const Trace slave = make_line(3., 0., 1., 5, degree), master = make_line(0., 3., 1., 7, 1);
    const MortarCoupling coupling = couple(slave, master, geometric);
    const Index n = coupling.weights.size();
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j)
      {
        EXPECT_NEAR(coupling.slave.coeff(i, 2 * j), 0., 1e-15); // n = (0, 1)
        EXPECT_NEAR(coupling.slave.coeff(i, 2 * j + 1), i == j ? -coupling.weights[i] : 0., 1e-15) << degree;
      }
  }
}

TEST(TraceCoupling, WeightsAreTheIntegralsOfTheShapeFunctions)
{
  // Gauss-Lobatto weights: on degree 2, 1/6, 4/6, 1/6 of a segment.
  const MortarCoupling coupling = couple(make_line(2., 0., 0., 2, 2), make_line(0., 2., 0., 3, 2), geometric);
  Eigen::VectorXd expected(5);
  expected << 1., 4., 2., 4., 1.;
  EXPECT_LT((coupling.weights - expected / 6.).norm(), 1e-15);
  EXPECT_NEAR(coupling.covered_length, 2., 1e-15);
}

TEST(TraceCoupling, WeightsSumUpToTheCoveredLength)
{
  const MortarCoupling whole = couple(make_arc(1., 1., 0., 9, 2), make_arc(1.1, -.2, 1.3, 11, 2), geometric);
  EXPECT_NEAR(whole.weights.sum(), 1., 1e-8);
  EXPECT_NEAR(whole.covered_length, 1., 1e-8);
  const MortarCoupling part = couple(make_line(4., 0., 0., 4), make_line(.5, 2.75, 0., 3), geometric);
  EXPECT_NEAR(part.weights.sum(), 2.25, 1e-14);
  EXPECT_NEAR(part.covered_length, 2.25, 1e-14);
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

TEST(TraceCoupling, ReproducesALinearGap)
{
  const auto linear = [](const Vector2 &x, double) { return .3 - .2 * x.x(); };
  const auto inclined = [](const double x) { return Vector2(x, 1.3 - .2 * x); };
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const Trace slave = make_line(3., 0., 1., 5, degree);
    const Trace master = make_curve(inclined, parameters(-.1, 3.1, 7), 1, 1);
    for (const GapFunction &gap : {GapFunction(linear), GapFunction(geometric)})
    {
      const MortarCoupling coupling = couple(slave, master, gap);
      for (Index i = 0; i < coupling.weights.size(); ++i)
      {
        const double x = slave.node_points()[static_cast<std::size_t>(i)].x();
        EXPECT_NEAR(coupling.gap[i] / coupling.weights[i], .3 - .2 * x, 1e-14) << degree;
      }
      EXPECT_LT(coupling.smallest_gap, -.28);
      EXPECT_GE(coupling.smallest_gap, -.3);
      EXPECT_GT(coupling.largest_gap, .28);
      EXPECT_LE(coupling.largest_gap, .3);
    }
  }
}

TEST(TraceCoupling, RigidAndLinearDisplacementsChangeTheGapAsTheyShould)
{
  // u_s = (0, a + b x) and u_m = (0, c + d x): the gap grows by u_m - u_s, for any meshes.
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const Trace slave = make_line(3., 0., 1., 5, degree), master = make_line(0., 3., 1., 7, 1);
    const MortarCoupling coupling = couple(slave, master, geometric);
    const auto displacement = [](const Trace &trace, const double at_zero, const double slope) {
      Eigen::VectorXd u = Eigen::VectorXd::Ones(static_cast<Index>(2 * trace.n_nodes()));
      for (std::size_t i = 0; i < trace.n_nodes(); ++i)
        u[static_cast<Index>(2 * i + 1)] = at_zero + slope * trace.node_points()[i].x();
      return u;
    };
    const Eigen::VectorXd change =
        coupling.slave * displacement(slave, .5, -2.) + coupling.master * displacement(master, .1, 3.);
    for (Index i = 0; i < change.size(); ++i)
      EXPECT_NEAR(change[i] / coupling.weights[i],
                  -.4 + 5. * slave.node_points()[static_cast<std::size_t>(i)].x(), 1e-12);
  }
}

TEST(TraceCoupling, UncoveredNodesHaveNoMultiplier)
{
  const auto one = [](const Vector2 &, double) { return 1.; };
  const Trace slave = make_line(4., 0., 0., 4);
  const MortarCoupling coupling = couple(slave, make_line(0., 1.5, 0., 3), one);
  // Nodes at x = 4, 3, 2, 1, 0; covered is [0, 1.5].
  for (const Index i : {0, 1})
  {
    EXPECT_EQ(coupling.weights[i], 0.);
    EXPECT_EQ(coupling.gap[i], 0.);
    EXPECT_EQ(coupling.slave.row(i).norm(), 0.);
    EXPECT_EQ(coupling.master.row(i).norm(), 0.);
  }
  EXPECT_NEAR(coupling.weights[2], .125, 1e-15);
  EXPECT_NEAR(coupling.weights[3], .875, 1e-15);
  EXPECT_NEAR(coupling.weights[4], .5, 1e-15);
  for (const Index i : {2, 3, 4})
    EXPECT_NEAR(coupling.gap[i] / coupling.weights[i], 1., 1e-14);
}

TEST(TraceCoupling, ACoverThatBarelyReachesANodeLeavesItOut)
{
  // Of the node at x = 1 the cover beyond 1 + 1e-4 would give (1e-4)^2 / 2 of its weight.
  const MortarCoupling coupling =
      couple(make_line(2., 0., 0., 2), make_line(2. - 1e-4, 2., 0., 1), geometric);
  EXPECT_GT(coupling.weights[0], 0.);
  EXPECT_EQ(coupling.weights[1], 0.);
  EXPECT_EQ(coupling.weights[2], 0.);
}
