// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/compliance_sum.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Those multipliers of a block that are active.
    struct ActivePart
    {
      const Eigen::MatrixXd *matrix;
      std::vector<Index> in_block;  ///< their places there
      std::vector<Index> in_active; ///< and in the active set, increasing
    };

    std::vector<ActivePart> active_parts(const ActiveSet &active, const std::vector<ComplianceBlock> &blocks)
    {
      std::vector<ActivePart> parts;
      for (const ComplianceBlock &block : blocks)
      {
        Assert(std::is_sorted(block.columns.begin(), block.columns.end()),
               dealii::ExcMessage("multipliers of a block are in increasing order"));
        ActivePart part{&block.matrix, {}, {}};
        auto next = active.begin();
        for (std::size_t k = 0; k < block.columns.size(); ++k)
        {
          next = std::lower_bound(next, active.end(), block.columns[k]);
          if (next == active.end())
            break;
          if (*next != block.columns[k])
            continue;
          part.in_block.push_back(static_cast<Index>(k));
          part.in_active.push_back(next - active.begin());
        }
        parts.push_back(std::move(part));
      }
      return parts;
    }

    /// A column of a lower triangle, summed up from parts.
    class LowerColumn
    {
    public:
      explicit LowerColumn(const Index size) : values_(size), column_of_(static_cast<std::size_t>(size), -1)
      {}

      /// With zero on the diagonal.
      void begin(const Index column)
      {
        column_ = column;
        rows_.clear();
        enter(column);
      }
      /// What the part's multiplier `place`, which is that of the column, has on and below the diagonal.
      void add(const ActivePart &part, const std::size_t place)
      {
        const auto n_before = static_cast<std::ptrdiff_t>(rows_.size());
        for (std::size_t k = place; k < part.in_active.size(); ++k)
        {
          const Index row = part.in_active[k];
          enter(row);
          values_[row] += (*part.matrix)(part.in_block[k], part.in_block[place]);
        }
        std::inplace_merge(rows_.begin(), rows_.begin() + n_before, rows_.end());
      }
      void append_to(Eigen::SparseMatrix<double> &matrix) const
      {
        matrix.startVec(column_);
        for (const Index row : rows_)
          matrix.insertBack(row, column_) = values_[row];
      }

    private:
      void enter(const Index row)
      {
        Index &column = column_of_[static_cast<std::size_t>(row)];
        if (column == column_)
          return;
        column = column_;
        values_[row] = 0.;
        rows_.push_back(row);
      }

      Index column_ = -1;
      std::vector<Index> rows_;      ///< increasing
      Eigen::VectorXd values_;       ///< by row
      std::vector<Index> column_of_; ///< that a row has its value for
    };
  } // namespace

  Eigen::SparseMatrix<double> sum_on(const ActiveSet &active, const std::vector<ComplianceBlock> &blocks)
  {
    Assert(std::is_sorted(active.begin(), active.end()),
           dealii::ExcMessage("active sets are in increasing order"));
    const std::vector<ActivePart> parts = active_parts(active, blocks);
    std::vector<std::size_t> next(parts.size(), 0); // of each part's multipliers
    const auto n = static_cast<Index>(active.size());
    LowerColumn column(n);
    Eigen::SparseMatrix<double> sum(n, n);
    for (Index j = 0; j < n; ++j)
    {
      column.begin(j);
      for (std::size_t p = 0; p < parts.size(); ++p)
        if (next[p] < parts[p].in_active.size() && parts[p].in_active[next[p]] == j)
          column.add(parts[p], next[p]++);
      column.append_to(sum);
    }
    sum.finalize();
    return sum;
  }
} // namespace abut
