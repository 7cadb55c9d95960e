// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>
#include <abut/bem/kernel_products.h>
#include <abut/bem/large_matrix.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    /// Real and imaginary parts of vectors of one size, as columns.
    template <typename... Vectors>
    Eigen::MatrixXd as_parts(const Eigen::VectorXcd &first, const Vectors &...others)
    {
      Eigen::MatrixXd parts(first.size(), 2 + 2 * static_cast<Eigen::Index>(sizeof...(others)));
      Eigen::Index column = 0;
      const auto add = [&](const Eigen::VectorXcd &vector) {
        parts.col(column++) = vector.real();
        parts.col(column++) = vector.imag();
      };
      add(first);
      (add(others), ...);
      return parts;
    }

    Eigen::VectorXcd from_parts(const Eigen::MatrixXd &parts, const Eigen::Index vector)
    {
      Eigen::VectorXcd x(parts.rows());
      x.real() = parts.col(2 * vector);
      x.imag() = parts.col(2 * vector + 1);
      return x;
    }
  } // namespace

  void KernelBlock::resize(const Eigen::Index rows, const Eigen::Index columns)
  {
    for (Eigen::MatrixXd *matrix : {&log, &even_real, &even_imag, &double_layer})
      *matrix = large_matrix(rows, columns);
  }

  void KernelBlock::set(const Eigen::Index row, const Eigen::Index column, const PairIntegrals &integrals)
  {
    for (Eigen::Index j = 0; j < integrals.log.cols(); ++j)
      for (Eigen::Index i = 0; i < integrals.log.rows(); ++i)
      {
        log(row + i, column + j) = integrals.log(i, j);
        even_real(row + i, column + j) = integrals.even_real(i, j);
        even_imag(row + i, column + j) = integrals.even_imag(i, j);
        double_layer(row + i, column + j) = integrals.double_layer(i, j);
      }
  }

  void KernelBlock::set_reversed(const Eigen::Index row, const Eigen::Index column,
                                 const PairIntegrals &integrals)
  {
    for (Eigen::Index j = 0; j < integrals.log.rows(); ++j)
      for (Eigen::Index i = 0; i < integrals.log.cols(); ++i)
      {
        log(row + i, column + j) = integrals.log(j, i);
        even_real(row + i, column + j) = integrals.even_real(j, i);
        even_imag(row + i, column + j) = integrals.even_imag(j, i);
        double_layer(row + i, column + j) = integrals.reversed(j, i);
      }
  }

  KernelProducts KernelBlock::multiply(const KernelDensities &densities,
                                       const Eigen::VectorXcd &own_traction) const
  {
    AssertDimension(densities.traction.size(), log.cols());
    AssertDimension(own_traction.size(), log.rows());
    const Eigen::MatrixXd both = as_parts(densities.traction, densities.slope),
                          by_log = blas_product(log, both), by_real = blas_product(even_real, both),
                          by_imag = blas_product(even_imag, both);
    const Complex i(0., 1.);
    return {from_parts(by_log, 0),
            from_parts(by_real, 0) + i * from_parts(by_imag, 0),
            from_parts(by_log, 1),
            from_parts(by_real, 1) + i * from_parts(by_imag, 1),
            from_parts(blas_product(double_layer, as_parts(densities.displacement)), 0),
            from_parts(transposed_blas_product(double_layer, as_parts(own_traction)), 0)};
  }
} // namespace abut
