// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/large_matrix.h>
#include <abut/bem/layer_operators.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace abut
{
  namespace
  {
    /// left^T [potential of every column], the potential of column j added by add(j, potential).
    template <typename Add>
    Eigen::MatrixXd tested_potentials(const LegendreBasis &left, const Eigen::Index n_columns, const Add &add)
    {
      Eigen::MatrixXd result = large_matrix(left.cols(), n_columns);
      Eigen::VectorXd potential(left.rows());
      for (Eigen::Index j = 0; j < n_columns; ++j)
      {
        potential.setZero();
        add(j, potential);
        result.col(j) = left.transpose() * potential;
      }
      return result;
    }
  } // namespace

  LayerOperators::LayerOperators(KernelMatrices kernels, const double poisson_ratio)
      : kernels_(std::move(kernels)), poisson_ratio_(poisson_ratio), elastic_(poisson_ratio)
  {
    AssertDimension(kernels_.log.rows(), kernels_.lengths.size() * (kernels_.degree + 1));
  }

  void LayerOperators::add(const Kernel &kernel, const Eigen::Index component, const Eigen::Index row,
                           const double value, Eigen::VectorXd &potential) const
  {
    const Eigen::Index n = kernels_.log.rows(), size = kernels_.degree + 1;
    const double even = component == 0 ? kernel.even : -kernel.even;
    auto same = potential.segment(component * n, n);
    same += value * (kernel.log * kernels_.log.col(row) + even * kernels_.even_real.col(row));
    potential.segment((1 - component) * n, n) -= (value * kernel.even) * kernels_.even_imag.col(row);
    if (row % size == 0)
      for (Eigen::Index m = 0; m < kernels_.lengths.size(); ++m)
        same[m * size] += value * kernel.even * kernels_.lengths[row / size] * kernels_.lengths[m];
  }

  void LayerOperators::add(const Kernel &kernel, const LegendreBasis &basis, const Eigen::Index column,
                           Eigen::VectorXd &potential) const
  {
    const Eigen::Index n = kernels_.log.rows();
    for (LegendreBasis::InnerIterator entry(basis, column); entry; ++entry)
      add(kernel, entry.row() / n, entry.row() % n, entry.value(), potential);
  }

  void LayerOperators::add_double_layer(const DisplacementBasis &basis, const Eigen::Index column,
                                        Eigen::VectorXd &potential) const
  {
    const Eigen::Index n = kernels_.log.rows();
    for (LegendreBasis::InnerIterator entry(basis.values, column); entry; ++entry)
      potential.segment(entry.row() / n * n, n) += entry.value() * kernels_.double_layer.col(entry.row() % n);
    for (LegendreBasis::InnerIterator entry(basis.slopes, column); entry; ++entry)
    {
      const Eigen::Index component = entry.row() / n;
      add(elastic_.rotated, 1 - component, entry.row() % n, component == 0 ? entry.value() : -entry.value(),
          potential);
    }
  }

  Eigen::MatrixXd LayerOperators::single_layer(const LegendreBasis &left, const LegendreBasis &right) const
  {
    AssertDimension(left.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.rows(), 2 * kernels_.log.rows());
    return tested_potentials(left, right.cols(), [&](const Eigen::Index j, Eigen::VectorXd &potential) {
      add(elastic_.single, right, j, potential);
    });
  }

  Eigen::MatrixXd LayerOperators::double_layer(const LegendreBasis &left,
                                               const DisplacementBasis &right) const
  {
    AssertDimension(left.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.values.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.slopes.cols(), right.values.cols());
    return tested_potentials(
        left, right.values.cols(),
        [&](const Eigen::Index j, Eigen::VectorXd &potential) { add_double_layer(right, j, potential); });
  }

  Eigen::MatrixXd LayerOperators::hypersingular(const DisplacementBasis &left,
                                                const DisplacementBasis &right) const
  {
    AssertDimension(left.slopes.rows(), 2 * kernels_.log.rows());
    AssertDimension(right.slopes.rows(), 2 * kernels_.log.rows());
    return tested_potentials(left.slopes, right.slopes.cols(),
                             [&](const Eigen::Index j, Eigen::VectorXd &potential) {
                               add(elastic_.hypersingular, right.slopes, j, potential);
                             });
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
