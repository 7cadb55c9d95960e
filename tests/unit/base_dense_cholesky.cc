// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>

#include <gtest/gtest.h>

#include <limits>

using namespace abut;

namespace
{
  /// 1 / (i + j + 1) and the unit matrix: condition 3.
  Eigen::MatrixXd definite(const Eigen::Index n)
  {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < n; ++i)
        matrix(i, j) += 1. / static_cast<double>(i + j + 1);
    return matrix;
  }
} // namespace

TEST(DenseCholesky, SolvesByTheLowerTriangle)
{
  for (const Eigen::Index n : {0, 1, 2, 17, 200})
  {
    const Eigen::MatrixXd matrix = definite(n), exact = Eigen::MatrixXd::Random(n, 3);
    Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();
    const DenseCholesky factor(lower);
    ASSERT_TRUE(factor.is_positive_definite());
    EXPECT_EQ(factor.rows(), n);
    EXPECT_LE((factor.solve(matrix * exact) - exact).norm(), 1e-14 * static_cast<double>(n));
    EXPECT_EQ(factor.solve(Eigen::MatrixXd(n, 0)).cols(), 0);
  }
}

TEST(DenseCholesky, TellsAMatrixThatIsNotPositiveDefinite)
{
  for (const double entry : {0., -1., std::numeric_limits<double>::quiet_NaN()})
  {
    Eigen::MatrixXd matrix = definite(100);
    matrix(70, 70) = entry;
    EXPECT_FALSE(DenseCholesky(matrix).is_positive_definite()) << entry;
  }
}
