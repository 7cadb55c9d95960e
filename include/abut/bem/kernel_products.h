// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/pair_integrals.h>

#include <Eigen/Core>

namespace abut
{
  /// Fields on the boundary: complex Legendre coefficients, in the rows of KernelMatrices.
  struct KernelDensities
  {
    Eigen::VectorXcd traction, displacement, slope;
  };

  /// What KernelMatrices make of them.
  struct KernelProducts
  {
    Eigen::VectorXcd traction_log, traction_even;
    Eigen::VectorXcd slope_log, slope_even;   ///< even: of (even_real + i even_imag)
    Eigen::VectorXcd double_layer;            ///< of the displacement
    Eigen::VectorXcd transposed_double_layer; ///< of the traction
  };

  /// Integrals of some elements, the rows, with some elements, the columns; see KernelMatrices.
  struct KernelBlock
  {
    Eigen::MatrixXd log;                  ///< int int P_i P_j ln |w|
    Eigen::MatrixXd even_real, even_imag; ///< int int P_i P_j conj(w)/w
    /**
     * -(1/2 pi) Im(direction_y int int P_i P_j/w), which is int int P_i P_j d/dn(y) (-ln |w|/(2 pi)) with the
     * outward normal. Zero for elements of one line.
     */
    Eigen::MatrixXd double_layer;

    void resize(Eigen::Index rows, Eigen::Index columns);
    /// The block of two elements that begins there, and that of the elements in the other order.
    void set(Eigen::Index row, Eigen::Index column, const PairIntegrals &integrals);
    void set_reversed(Eigen::Index row, Eigen::Index column, const PairIntegrals &integrals);
    /// `densities` stand on the elements of the columns, `own_traction` on those of the rows.
    KernelProducts multiply(const KernelDensities &densities, const Eigen::VectorXcd &own_traction) const;
  };
} // namespace abut
