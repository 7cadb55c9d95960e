// SPDX-License-Identifier: LGPL-2.1-or-later
// How active sets change: min x . Q x / 2 + b . x over x >= 0 by solutions on sets alone.
#include <abut/decomposition/schemes/pivoting.h>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  struct Solved
  {
    Eigen::VectorXd x, slack;
    std::vector<Index> infeasible;
  };

  Solved solve_on(const std::vector<bool> &active, const Eigen::MatrixXd &q, const Eigen::VectorXd &b)
  {
    std::vector<Index> set;
    for (std::size_t k = 0; k < active.size(); ++k)
      if (active[k])
        set.push_back(static_cast<Index>(k));
    Solved solved{Eigen::VectorXd::Zero(b.size()), {}, {}};
    if (!set.empty())
    {
      const Eigen::MatrixXd matrix = q(set, set);
      const Eigen::VectorXd right_side = -b(set);
      const Eigen::VectorXd solution = matrix.llt().solve(right_side);
      solved.x(set) = solution;
    }
    solved.slack = q * solved.x + b;
    const auto violation = [&](const Index i) {
      return active[static_cast<std::size_t>(i)] ? -solved.x[i] : -solved.slack[i];
    };
    const double small = 1e-11 * b.norm();
    for (Index i = 0; i < b.size(); ++i)
      if (violation(i) > small)
        solved.infeasible.push_back(i);
    std::sort(solved.infeasible.begin(), solved.infeasible.end(),
              [&](const Index i, const Index j) { return violation(i) > violation(j); });
    return solved;
  }

  /// Sets visited until the minimum, which is checked; 0 where the descent gives up.
  unsigned int steps_of_descent(const Eigen::MatrixXd &q, const Eigen::VectorXd &b,
                                const Eigen::VectorXd &start)
  {
    constexpr unsigned int most = 10000;
    ActiveSetDescent descent(start);
    std::vector<bool> active = descent.active();
    for (unsigned int steps = 1; steps < most; ++steps)
    {
      const Solved solved = solve_on(active, q, b);
      if (solved.infeasible.empty())
      {
        EXPECT_GE(solved.x.minCoeff(), -1e-10);
        EXPECT_GE(solved.slack.minCoeff(), -1e-10);
        EXPECT_NEAR(solved.x.dot(solved.slack), 0., 1e-10);
        return steps;
      }
      if (!descent.advance(solved.x, solved.infeasible, active))
        return 0;
    }
    return most;
  }
} // namespace

TEST(DecompositionPivoting, BlocksGiveUpAfterThreeTriesWithoutProgress)
{
  BlockPivoting pivoting;
  std::vector<bool> active = {true, false, false};
  EXPECT_TRUE(pivoting.flip({0, 1, 2}, active));
  EXPECT_EQ(active, (std::vector<bool>{false, true, true}));
  for (int i = 0; i < 3; ++i) // fewer: three tries anew
    EXPECT_TRUE(pivoting.flip({0, 1}, active));
  EXPECT_EQ(active, (std::vector<bool>{true, false, true}));
  EXPECT_FALSE(pivoting.flip({0, 2}, active));
  EXPECT_EQ(active, (std::vector<bool>{true, false, true}));
}

TEST(DecompositionPivoting, DescentFindsTheMinimumOfRandomProblems)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto entry = [&](Index, Index) { return normal(random); };
  unsigned int most = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Index n = 2 + trial % 30;
    const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(n, n, entry);
    const Eigen::MatrixXd q = factor * factor.transpose() + 1e-4 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd b = Eigen::MatrixXd::NullaryExpr(n, 1, entry),
                          start = Eigen::MatrixXd::NullaryExpr(n, 1, entry).cwiseMax(0.);
    const unsigned int steps = steps_of_descent(q, b, start);
    EXPECT_GT(steps, 0u) << trial;
    EXPECT_LT(steps, 6 * n) << trial;
    most = std::max(most, steps);
  }
  std::cout << "most sets of a random problem: " << most << '\n';
}

// Changing single entries by the least index takes 2^n sets here [Fathi1979].
TEST(DecompositionPivoting, DescentIsNotExponentialWhereSingleExchangesAre)
{
  for (const Index n : {8, 16, 24})
  {
    Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(n, n);
    lower.triangularView<Eigen::StrictlyLower>().setConstant(2.);
    const unsigned int steps =
        steps_of_descent(lower * lower.transpose(), -Eigen::VectorXd::Ones(n), Eigen::VectorXd::Zero(n));
    EXPECT_GT(steps, 0u) << n;
    EXPECT_LT(steps, 6 * n) << n;
    std::cout << "n = " << n << ": " << steps << " sets\n";
  }
}

TEST(DecompositionPivoting, DescentNoticesThatItTurnsInACircle)
{
  // A liar says that the same entry overlaps on every set that it is not in, and pulls where it is.
  ActiveSetDescent descent(Eigen::VectorXd::Unit(2, 0));
  std::vector<bool> active = descent.active();
  int steps = 0;
  while (steps < 100)
  {
    const Eigen::VectorXd x =
        active[1] ? Eigen::VectorXd(Eigen::Vector2d(1., -1.)) : Eigen::VectorXd::Unit(2, 0);
    if (!descent.advance(x, {1}, active))
      break;
    ++steps;
  }
  EXPECT_LT(steps, 10);
}
