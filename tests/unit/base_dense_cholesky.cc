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

TEST(DenseCholesky, SolvesWithHalfOfTheFactor)
{
  // L^-T L^-1 b = A^-1 b, and |L^-1 b|^2 = b . A^-1 b.
  const Eigen::Index n = 60;
  const Eigen::MatrixXd matrix = definite(n), exact = Eigen::MatrixXd::Random(n, 4);
  const DenseCholesky factor(matrix);
  Eigen::MatrixXd half = matrix * exact;
  factor.solve_lower(half);
  Eigen::MatrixXd energies = Eigen::MatrixXd::Identity(4, 4);
  add_gram_matrix(half, energies);
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Identity(4, 4) + exact.transpose() * matrix * exact;
  EXPECT_LE((energies - expected).norm(), 1e-13 * expected.norm());
  factor.solve_upper(half);
  EXPECT_LE((half - exact).norm(), 1e-13 * exact.norm());
}

TEST(DenseCholesky, MultipliesAsEigenDoes)
{
  for (const Eigen::Index rows : {0, 1, 7, 60})
    for (const Eigen::Index inner : {0, 1, 5, 90})
    {
      const Eigen::MatrixXd a = Eigen::MatrixXd::Random(rows, inner), b = Eigen::MatrixXd::Random(inner, 4),
                            c = Eigen::MatrixXd::Random(rows, 2);
      EXPECT_LE((blas_product(a, b) - a * b).norm(), 1e-14 * a.norm() * b.norm());
      EXPECT_LE((transposed_blas_product(a, c) - a.transpose() * c).norm(), 1e-14 * a.norm() * c.norm());
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
