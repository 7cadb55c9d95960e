// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/congruence.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cstdlib>

using namespace abut;

namespace
{
  using Matrix = Eigen::SparseMatrix<double>;

  /// A tenth of the entries, and the diagonal.
  Matrix some_symmetric(const Eigen::Index n)
  {
    Eigen::MatrixXd entries = Eigen::MatrixXd::Random(n, n);
    entries = (entries.array() > .8).select(entries, 0.);
    return (entries + entries.transpose() + 2. * Eigen::MatrixXd::Identity(n, n)).sparseView();
  }

  /// As constraints have it: most rows with a one, in no order; some empty, some with three entries.
  Matrix constraints(const Eigen::Index n, const Eigen::Index n_free)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
    {
      const auto column = [&](const int k) { return (7 * i + k) % static_cast<int>(n_free); };
      if (i % 5 == 1)
        for (const int k : {0, 3, 5})
          entries.emplace_back(i, column(k), .25 * (k - 2));
      else if (i % 5 != 2)
        entries.emplace_back(i, column(0), 1.);
    }
    Matrix t(n, n_free);
    t.setFromTriplets(entries.begin(), entries.end());
    return t;
  }
} // namespace

TEST(Congruence, IsTheLowerTriangleOfTheTwoProducts)
{
  std::srand(5);
  for (const Eigen::Index n : {1, 8, 60})
  {
    const Matrix a = some_symmetric(n), t = constraints(n, n > 8 ? n - 20 : n);
    const Matrix result = lower_congruent(a, t);
    const Eigen::MatrixXd whole = Eigen::MatrixXd(t).transpose() * Eigen::MatrixXd(a) * Eigen::MatrixXd(t);
    const Eigen::MatrixXd lower = whole.triangularView<Eigen::Lower>();
    EXPECT_LE((Eigen::MatrixXd(result) - lower).cwiseAbs().maxCoeff(), 1e-14 * whole.cwiseAbs().maxCoeff());
    EXPECT_TRUE(result.isCompressed());
    for (Eigen::Index j = 0; j < result.cols(); ++j)
    {
      Eigen::Index before = j - 1; // rows from the diagonal on, each once, in order
      for (Matrix::InnerIterator entry(result, j); entry; ++entry)
      {
        EXPECT_GT(entry.row(), before);
        before = entry.row();
      }
    }
  }
}

TEST(Congruence, WithoutConstraintsIsTheMatrix)
{
  const Matrix a = some_symmetric(12);
  Matrix identity(12, 12);
  identity.setIdentity();
  const Matrix lower = a.triangularView<Eigen::Lower>();
  EXPECT_EQ((Eigen::MatrixXd(lower_congruent(a, identity)) - Eigen::MatrixXd(lower)).norm(), 0.);
}

TEST(Congruence, OfNothingIsEmpty)
{
  EXPECT_EQ(lower_congruent(some_symmetric(4), Matrix(4, 0)).cols(), 0);
}
