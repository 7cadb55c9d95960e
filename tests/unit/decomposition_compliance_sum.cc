// SPDX-License-Identifier: LGPL-2.1-or-later
// The sum of compliance blocks on active sets, beside the same sum as a dense matrix.
#include <abut/decomposition/compliance_sum.h>

#include <gtest/gtest.h>

#include <random>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// Symmetric, of these multipliers, with a row more that is no gap.
  ComplianceBlock block_on(const std::vector<Index> &columns, std::mt19937 &numbers)
  {
    ComplianceBlock block;
    block.columns = block.rows = columns;
    block.rows.push_back(1000);
    const auto n = static_cast<Index>(columns.size());
    const Eigen::MatrixXd random =
        Eigen::MatrixXd::NullaryExpr(n, n, [&]() { return std::generate_canonical<double, 53>(numbers); });
    block.matrix = Eigen::MatrixXd::Zero(n + 1, n);
    block.matrix.topRows(n) = random + random.transpose();
    return block;
  }

  Eigen::MatrixXd dense_sum(const Index n, const std::vector<ComplianceBlock> &blocks)
  {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (const ComplianceBlock &block : blocks)
      sum(block.columns, block.columns) += block.matrix.topRows(static_cast<Index>(block.columns.size()));
    return sum;
  }
} // namespace

TEST(DecompositionComplianceSum, IsThatOfTheWholeMatrices)
{
  std::mt19937 numbers(1);
  constexpr Index n = 9;
  // A chain of bodies, one that touches the first and the last, and multiplier 8 that no block knows.
  const std::vector<ComplianceBlock> blocks = {block_on({0, 1, 2}, numbers),
                                               block_on({0, 1, 2, 3, 4}, numbers),
                                               block_on({3, 4, 5, 6, 7}, numbers), block_on({1, 7}, numbers)};
  const Eigen::MatrixXd whole = dense_sum(n, blocks);
  for (const ActiveSet &active : {ActiveSet{0, 1, 2, 3, 4, 5, 6, 7, 8}, ActiveSet{1, 3, 4, 7},
                                  ActiveSet{2, 8}, ActiveSet{5}, ActiveSet{}})
  {
    const Eigen::SparseMatrix<double> sum = sum_on(active, blocks);
    const Eigen::MatrixXd expected = whole(active, active).triangularView<Eigen::Lower>();
    ASSERT_EQ(sum.rows(), expected.rows());
    EXPECT_TRUE(Eigen::MatrixXd(sum).isApprox(expected, 1e-15)) << Eigen::MatrixXd(sum);
    for (Index k = 0; k < sum.cols(); ++k) // also where no block has it
    {
      const Eigen::SparseMatrix<double>::InnerIterator entry(sum, k);
      ASSERT_TRUE(entry);
      EXPECT_EQ(entry.row(), k);
    }
  }
}

TEST(DecompositionComplianceSum, HasNoEntriesBetweenBodiesThatDoNotTouch)
{
  std::mt19937 numbers(1);
  const std::vector<ComplianceBlock> blocks = {block_on({0, 1}, numbers), block_on({2, 3, 4}, numbers)};
  EXPECT_EQ(sum_on({0, 1, 2, 3, 4}, blocks).nonZeros(), 3 + 6);
}
