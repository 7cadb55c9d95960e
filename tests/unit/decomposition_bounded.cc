// SPDX-License-Identifier: LGPL-2.1-or-later
// Small problems with bounds against all their active sets.
#include <abut/base/user_error.h>
#include <abut/decomposition/schemes/nonnegative_fit.h>
#include <abut/decomposition/schemes/projected_gradients.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace abut;

namespace
{
  constexpr int n_unknowns = 7;

  Eigen::MatrixXd random_matrix(const int rows, std::mt19937 &generator)
  {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, n_unknowns, [&] { return normal(generator); });
  }

  /// The minimiser of x . Q x / 2 + b . x over x >= 0: the best of the 2^n solutions on faces.
  Eigen::VectorXd best_of_all_faces(const Eigen::MatrixXd &q, const Eigen::VectorXd &b)
  {
    Eigen::VectorXd best = Eigen::VectorXd::Zero(n_unknowns);
    double least = 0.;
    for (unsigned int face = 1; face < (1u << n_unknowns); ++face)
    {
      // The unknowns off the face have equations x_i = 0 of their own.
      Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n_unknowns, n_unknowns);
      Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n_unknowns);
      for (int i = 0; i < n_unknowns; ++i)
        if ((face >> i) & 1u)
        {
          right_side[i] = -b[i];
          for (int j = 0; j < n_unknowns; ++j)
            system(i, j) = (face >> j) & 1u ? q(i, j) : 0.;
        }
      const Eigen::VectorXd x = system.partialPivLu().solve(right_side);
      if (x.minCoeff() < 0.)
        continue;
      const double value = .5 * x.dot(q * x) + b.dot(x);
      if (value < least)
      {
        least = value;
        best = x;
      }
    }
    return best;
  }
} // namespace

TEST(DecompositionBounded, ProjectedGradientsFindTheMinimum)
{
  std::mt19937 generator(3);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Eigen::MatrixXd a = random_matrix(9, generator), q = a.transpose() * a;
    const Eigen::VectorXd b = random_matrix(1, generator).row(0);
    const auto product = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd { return q * x; };
    const BoundedProblem problem{product, b, rough_norm(product, n_unknowns)};
    Eigen::VectorXd x = Eigen::VectorXd::Constant(n_unknowns, trial % 2 == 0 ? 0. : 1.);
    unsigned int products = 0;
    EXPECT_TRUE(ProjectedGradients(problem).solve(1e-12, 10000, products, x, {}));
    EXPECT_LT((x - best_of_all_faces(q, b)).norm(), 1e-8) << trial;
    unsigned int few = 0;
    Eigen::VectorXd start = Eigen::VectorXd::Constant(n_unknowns, 1.);
    EXPECT_FALSE(ProjectedGradients(problem).solve(1e-12, 2, few, start, {}));
  }
}

TEST(DecompositionBounded, TheLastProductCounts)
{
  // One unknown: one product for the gradient, one for the step that ends in the minimum.
  const auto product = [](const Eigen::VectorXd &x) -> Eigen::VectorXd { return 2. * x; };
  const BoundedProblem problem{product, Eigen::VectorXd::Constant(1, -2.), 2.};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
  unsigned int products = 0;
  EXPECT_TRUE(ProjectedGradients(problem).solve(1e-12, 2, products, x, {}));
  EXPECT_EQ(products, 2u);
  EXPECT_DOUBLE_EQ(x[0], 1.);
}

TEST(DecompositionBounded, NoPositiveCurvatureIsRefused)
{
  for (const double curvature :
       {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const double start : {0., 1.}) // at the bound and off it
    {
      const auto product = [&](const Eigen::VectorXd &x) -> Eigen::VectorXd {
        return x.isZero(0.) ? x : Eigen::VectorXd(curvature * x);
      };
      const BoundedProblem problem{product, Eigen::VectorXd::Constant(1, -2.), 1.};
      Eigen::VectorXd x = Eigen::VectorXd::Constant(1, start);
      unsigned int products = 0;
      EXPECT_THROW(ProjectedGradients(problem).solve(1e-12, 100, products, x, {}), ComputationError)
          << curvature << ' ' << start;
    }
}

TEST(DecompositionBounded, NonnegativeFitIsTheBestOfAllFaces)
{
  std::mt19937 generator(5);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Eigen::MatrixXd a = random_matrix(9, generator);
    const Eigen::VectorXd b = random_matrix(9, generator).col(0);
    const Eigen::VectorXd expected = best_of_all_faces(a.transpose() * a, -a.transpose() * b);
    EXPECT_TRUE(nonnegative_fit(a, b).optimal);
    EXPECT_LT((nonnegative_fit(a, b).x - expected).norm(), 1e-9 * (1. + expected.norm())) << trial;
  }
}

TEST(DecompositionBounded, NonnegativeFitOfMoreUnknownsThanEquations)
{
  std::mt19937 generator(9);
  const Eigen::MatrixXd a = random_matrix(3, generator);
  const Eigen::VectorXd b = a * Eigen::VectorXd::LinSpaced(n_unknowns, 0., 3.); // can be met
  const Eigen::VectorXd x = nonnegative_fit(a, b).x;
  EXPECT_GE(x.minCoeff(), 0.);
  EXPECT_LT((a * x - b).norm(), 1e-12 * b.norm());
}

TEST(DecompositionBounded, NonnegativeFitOfNothing)
{
  const NonnegativeFit fit = nonnegative_fit(Eigen::MatrixXd(3, 0), Eigen::VectorXd::Ones(3));
  EXPECT_EQ(fit.x.size(), 0);
  EXPECT_TRUE(fit.optimal);
}

TEST(DecompositionBounded, NonnegativeFitEndsWithColumnsAlike)
{
  // The first columns differ by less than round-off lets the fit tell: they must not be taken for ever, nor
  // keep the last one from its turn.
  std::mt19937 generator(7);
  for (int trial = 0; trial < 200; ++trial)
  {
    Eigen::MatrixXd a = random_matrix(9, generator);
    for (int j = 1; j < n_unknowns - 1; ++j)
      a.col(j) = 1e3 * (a.col(0) + 1e-14 * a.col(j));
    const Eigen::VectorXd b = a.col(0) * 1e3 + 1e-4 * a.col(n_unknowns - 1);
    const NonnegativeFit fit = nonnegative_fit(a, b);
    EXPECT_TRUE(fit.optimal) << trial;
    EXPECT_LT((a * fit.x - b).norm(), 1e-7 * b.norm()) << trial;
  }
}
