// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/large_matrix.h>
#include <abut/bem/layer_operators.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <utility>
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

  LayerOperators::LayerOperators(KernelMatrices kernels, const double poisson_ratio)
      : kernels_(std::move(kernels)), poisson_ratio_(poisson_ratio), elastic_(poisson_ratio)
  {
    AssertDimension(kernels_.log.rows(), kernels_.lengths.size() * (kernels_.degree + 1));
  }

  void LayerOperators::add(const Kernel &kernel, const Index component, const Index row, const double value,
                           const Index first, Eigen::VectorXd &potential) const
  {
    const Index n = kernels_.log.rows(), size = kernels_.degree + 1, n_rows = n - first;
    const double even = component == 0 ? kernel.even : -kernel.even;
    auto same = potential.segment(component * n, n);
    same.tail(n_rows) += value * (kernel.log * kernels_.log.col(row).tail(n_rows) +
                                  even * kernels_.even_real.col(row).tail(n_rows));
    potential.segment((1 - component) * n + first, n_rows) -=
        (value * kernel.even) * kernels_.even_imag.col(row).tail(n_rows);
    if (row % size == 0)
      for (Index m = (first + size - 1) / size; m < kernels_.lengths.size(); ++m)
        same[m * size] += value * kernel.even * kernels_.lengths[row / size] * kernels_.lengths[m];
  }

  void LayerOperators::add(const Kernel &kernel, const LegendreBasis &basis, const Index column,
                           const Index first, Eigen::VectorXd &potential) const
  {
    const Index n = kernels_.log.rows();
    for (LegendreBasis::InnerIterator entry(basis, column); entry; ++entry)
      add(kernel, entry.row() / n, entry.row() % n, entry.value(), first, potential);
  }

  void LayerOperators::add_double_layer(const DisplacementBasis &basis, const Index column,
                                        Eigen::VectorXd &potential) const
  {
    const Index n = kernels_.log.rows();
    for (LegendreBasis::InnerIterator entry(basis.values, column); entry; ++entry)
      potential.segment(entry.row() / n * n, n) += entry.value() * kernels_.double_layer.col(entry.row() % n);
    for (LegendreBasis::InnerIterator entry(basis.slopes, column); entry; ++entry)
    {
      const Index component = entry.row() / n;
      add(elastic_.rotated, 1 - component, entry.row() % n, component == 0 ? entry.value() : -entry.value(),
          0, potential);
    }
  }

  Eigen::MatrixXd LayerOperators::symmetric(const Kernel &kernel, const LegendreBasis &left,
                                            const LegendreBasis &right) const
  {
    AssertDimension(left.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.rows(), 2 * kernels_.log.rows());
    return tested_potentials(left, right.cols(), &left == &right,
                             [&](const Index j, const Index first, Eigen::VectorXd &potential) {
                               add(kernel, right, j, first, potential);
                             });
  }

  Eigen::MatrixXd LayerOperators::single_layer(const LegendreBasis &left, const LegendreBasis &right) const
  {
    return symmetric(elastic_.single, left, right);
  }

  Eigen::MatrixXd LayerOperators::hypersingular(const DisplacementBasis &left,
                                                const DisplacementBasis &right) const
  {
    return symmetric(elastic_.hypersingular, left.slopes, right.slopes);
  }

  Eigen::MatrixXd LayerOperators::double_layer(const LegendreBasis &left,
                                               const DisplacementBasis &right) const
  {
    AssertDimension(left.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.values.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.slopes.cols(), right.values.cols());
    return tested_potentials(
        left, right.values.cols(), false,
        [&](const Index j, Index, Eigen::VectorXd &potential) { add_double_layer(right, j, potential); });
  }

  LegendreBasis LayerOperators::mass(const LegendreBasis &left, const LegendreBasis &right) const
  {
    return legendre_mass(kernels_.lengths, kernels_.degree, left, right);
  }

  LegendreBasis legendre_mass(const Eigen::VectorXd &lengths, const unsigned int degree,
                              const LegendreBasis &left, const LegendreBasis &right)
  {
    const Eigen::Index size = degree + 1, n = lengths.size() * size;
    AssertDimension(left.rows(), 2 * n);
    AssertDimension(right.rows(), 2 * n);
    Eigen::VectorXd squares(2 * n);
    for (Eigen::Index row = 0; row < 2 * n; ++row)
      squares[row] = lengths[row % n / size] / (2. * static_cast<double>(row % size) + 1.);
    return left.transpose() * squares.asDiagonal() * right;
  }

  LegendreBasis as_basis(const Eigen::VectorXd &field)
  {
    return field.sparseView();
  }
} // namespace abut
