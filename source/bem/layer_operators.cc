// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/block_operators.h>
#include <abut/bem/layer_operators.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace abut
{
  LayerOperators::LayerOperators(KernelMatrices kernels, const double poisson_ratio)
      : kernels_(std::move(kernels)), poisson_ratio_(poisson_ratio), elastic_(poisson_ratio)
  {
    AssertDimension(kernels_.log.rows(), kernels_.lengths.size() * (kernels_.degree + 1));
  }

  Eigen::MatrixXd LayerOperators::symmetric(const ElasticKernels::Kernel &kernel, const LegendreBasis &left,
                                            const LegendreBasis &right) const
  {
    Eigen::MatrixXd result = BlockOperators(kernels_, poisson_ratio_).symmetric(kernel, left, right);
    result.noalias() += kernel.even * integrals(left) * integrals(right).transpose();
    return result;
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
    Eigen::Matrix2d rotation;
    rotation << 0., 1., -1., 0.;
    Eigen::MatrixXd result = BlockOperators(kernels_, poisson_ratio_).double_layer(left, right);
    result.noalias() +=
        elastic_.rotated.even * integrals(left) * (integrals(right.slopes) * rotation).transpose();
    return result;
  }

  Eigen::MatrixX2d LayerOperators::integrals(const LegendreBasis &basis) const
  {
    return legendre_integrals(kernels_.lengths, kernels_.degree, basis);
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

  Eigen::MatrixX2d legendre_integrals(const Eigen::VectorXd &lengths, const unsigned int degree,
                                      const LegendreBasis &basis)
  {
    const Eigen::Index size = degree + 1, n = lengths.size() * size;
    AssertDimension(basis.rows(), 2 * n);
    Eigen::MatrixX2d integrals = Eigen::MatrixX2d::Zero(basis.cols(), 2);
    for (Eigen::Index j = 0; j < basis.cols(); ++j)
      for (LegendreBasis::InnerIterator entry(basis, j); entry; ++entry)
        if (entry.row() % size == 0)
          integrals(j, entry.row() / n) += entry.value() * lengths[entry.row() % n / size];
    return integrals;
  }

  LegendreBasis as_basis(const Eigen::VectorXd &field)
  {
    return field.sparseView();
  }
} // namespace abut
