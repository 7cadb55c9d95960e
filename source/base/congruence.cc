// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/congruence.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <vector>

namespace abut
{
  namespace
  {
    using Matrix = Eigen::SparseMatrix<double>;

    /// One column of the result at a time, its entries in the order in which they come.
    class ColumnSums
    {
    public:
      explicit ColumnSums(const Eigen::Index n)
          : sums_(static_cast<std::size_t>(n), 0.), is_used_(static_cast<std::size_t>(n), false)
      {}

      void add(const Eigen::Index row, const double value)
      {
        const auto i = static_cast<std::size_t>(row);
        if (!is_used_[i])
          rows_.push_back(row);
        is_used_[i] = true;
        sums_[i] += value;
      }

      /// Appends them, in the order of rows, and begins again.
      void move_to(Matrix &result, const Eigen::Index column)
      {
        std::sort(rows_.begin(), rows_.end());
        result.startVec(column);
        for (const Eigen::Index row : rows_)
        {
          const auto i = static_cast<std::size_t>(row);
          result.insertBack(row, column) = sums_[i];
          sums_[i] = 0.;
          is_used_[i] = false;
        }
        rows_.clear();
      }

    private:
      std::vector<double> sums_;
      std::vector<bool> is_used_;
      std::vector<Eigen::Index> rows_;
    };
  } // namespace

  Matrix lower_congruent(const Matrix &a, const Matrix &t)
  {
    AssertDimension(a.rows(), a.cols());
    AssertDimension(a.cols(), t.rows());
    const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = t;
    Matrix result(t.cols(), t.cols());
    result.reserve(a.nonZeros() / 2 + t.cols());
    ColumnSums sums(t.cols());
    for (Eigen::Index j = 0; j < t.cols(); ++j)
    {
      for (Matrix::InnerIterator right(t, j); right; ++right)
        for (Matrix::InnerIterator middle(a, right.row()); middle; ++middle)
          for (decltype(rows)::InnerIterator left(rows, middle.row()); left; ++left)
            if (left.col() >= j)
              sums.add(left.col(), left.value() * middle.value() * right.value());
      sums.move_to(result, j);
    }
    result.finalize();
    return result;
  }
} // namespace abut
