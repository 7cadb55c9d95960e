// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/block_operators.h>
#include <abut/bem/large_matrix.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <vector>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// For every column the first row, of either component, in which it or a later one has an entry.
    std::vector<Index> first_rows(const LegendreBasis &basis, const Index n)
    {
      std::vector<Index> rows(static_cast<std::size_t>(basis.cols()));
      Index first = n;
      for (Index j = basis.cols(); j-- > 0;)
      {
        for (LegendreBasis::InnerIterator entry(basis, j); entry; ++entry)
          first = std::min(first, entry.row() % n);
        rows[static_cast<std::size_t>(j)] = first;
      }
      return rows;
    }

    /// left^T [potential of every column], the potential of column j added by add(j, first, potential), in
    /// the rows of either component from `first` on. Of a symmetric result half is computed.
    template <typename Add>
    Eigen::MatrixXd tested_potentials(const LegendreBasis &left, const Index n_columns,
                                      const bool is_symmetric, const Add &add)
    {
      const Index n = left.rows() / 2;
      const std::vector<Index> needed = first_rows(left, n);
      Eigen::MatrixXd result = large_matrix(left.cols(), n_columns);
      Eigen::VectorXd potential(left.rows());
      for (Index j = 0; j < n_columns; ++j)
      {
        const Index first_test = is_symmetric ? j : 0, n_tests = left.cols() - first_test,
                    first = is_symmetric ? needed[static_cast<std::size_t>(j)] : 0;
        potential.head(n).tail(n - first).setZero();
        potential.tail(n - first).setZero();
        add(j, first, potential);
        result.col(j).tail(n_tests).noalias() = left.rightCols(n_tests).transpose() * potential;
      }
      if (is_symmetric)
        complete_symmetric(result);
      return result;
    }
  } // namespace

  BlockOperators::BlockOperators(const KernelBlock &kernels, const double poisson_ratio)
      : kernels_(kernels), elastic_(poisson_ratio)
  {}

  void BlockOperators::add(const Kernel &kernel, const Index component, const Index column,
                           const double value, const Index first, Eigen::VectorXd &potential) const
  {
    const Index n = kernels_.log.rows(), n_rows = n - first;
    const double even = component == 0 ? kernel.even : -kernel.even;
    potential.segment(component * n + first, n_rows) +=
        value * (kernel.log * kernels_.log.col(column).tail(n_rows) +
                 even * kernels_.even_real.col(column).tail(n_rows));
    potential.segment((1 - component) * n + first, n_rows) -=
        (value * kernel.even) * kernels_.even_imag.col(column).tail(n_rows);
  }

  Eigen::MatrixXd BlockOperators::symmetric(const Kernel &kernel, const LegendreBasis &left,
                                            const LegendreBasis &right) const
  {
    const Index n = kernels_.log.cols();
    AssertDimension(left.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.rows(), 2 * n);
    return tested_potentials(left, right.cols(), &left == &right,
                             [&](const Index j, const Index first, Eigen::VectorXd &potential) {
                               for (LegendreBasis::InnerIterator entry(right, j); entry; ++entry)
                                 add(kernel, entry.row() / n, entry.row() % n, entry.value(), first,
                                     potential);
                             });
  }

  Eigen::MatrixXd BlockOperators::double_layer(const LegendreBasis &left,
                                               const DisplacementBasis &right) const
  {
    const Index n = kernels_.log.cols(), n_rows = kernels_.log.rows();
    AssertDimension(left.rows(), 2 * n_rows);
    AssertDimension(right.values.rows(), 2 * n);
    AssertDimension(right.slopes.cols(), right.values.cols());
    return tested_potentials(left, right.values.cols(), false,
                             [&](const Index j, Index, Eigen::VectorXd &potential) {
                               for (LegendreBasis::InnerIterator entry(right.values, j); entry; ++entry)
                                 potential.segment(entry.row() / n * n_rows, n_rows) +=
                                     entry.value() * kernels_.double_layer.col(entry.row() % n);
                               for (LegendreBasis::InnerIterator entry(right.slopes, j); entry; ++entry)
                               {
                                 const Index component = entry.row() / n;
                                 add(elastic_.rotated, 1 - component, entry.row() % n,
                                     component == 0 ? entry.value() : -entry.value(), 0, potential);
                               }
                             });
  }
} // namespace abut
