// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/pair_integrals.h>

#include <vector>

namespace abut
{
  /**
   * The integrals that plane elasticity of a homogeneous body is made of, independent of its material: over
   * x on the element of the row and y on the element of the column, w = y - x, against the Legendre
   * polynomials P_i(x) P_j(y); row or column = element (degree + 1) + degree of the polynomial. In
   * coordinates divided by about the body's diameter. See [HsiaoWendland2008, 2.2]
   * and [Sutradhar2008, ch. 3].
   */
  struct KernelMatrices
  {
    KernelMatrices(const std::vector<BoundaryElement> &elements, unsigned int degree);

    void set(std::size_t first, std::size_t second, const PairIntegrals &integrals);

    unsigned int degree;
    Eigen::VectorXd lengths;              ///< of the elements
    Eigen::MatrixXd log;                  ///< int int P_i P_j ln |w|, symmetric
    Eigen::MatrixXd even_real, even_imag; ///< int int P_i P_j conj(w)/w, symmetric
    /**
     * -(1/2 pi) Im(direction_y int int P_i P_j/w), which is int int P_i P_j d/dn(y) (-ln |w|/(2 pi)) with the
     * outward normal. Zero for elements of one line.
     */
    Eigen::MatrixXd double_layer;
  };

  /**
   * Every unordered pair is integrated once. `elements` run through closed curves with the body on their
   * left, with equal ends where they share a vertex; they may touch nowhere else.
   */
  KernelMatrices kernel_matrices(const std::vector<BoundaryElement> &elements, unsigned int degree,
                                 const GalerkinRule &rule);
} // namespace abut
