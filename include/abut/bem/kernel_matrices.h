// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/kernel_products.h>
#include <abut/bem/pair_integrals.h>

#include <vector>

namespace abut
{
  /**
   * The integrals that plane elasticity of a homogeneous body is made of, independent of its material: over
   * x on the element of the row and y on the element of the column, w = y - x, against the Legendre
   * polynomials P_i(x) P_j(y); row or column = element (degree + 1) + degree of the polynomial. In
   * coordinates divided by about the body's diameter. See [HsiaoWendland2008, 2.2]
   * and [Sutradhar2008, ch. 3]. All but the double layer are symmetric.
   */
  struct KernelMatrices : KernelBlock
  {
    KernelMatrices(const std::vector<BoundaryElement> &elements, unsigned int degree);

    /// Of the symmetric matrices the lower triangle alone.
    void set(std::size_t first, std::size_t second, const PairIntegrals &integrals);
    /// The upper one.
    void complete();

    unsigned int degree;
    Eigen::VectorXd lengths; ///< of the elements
  };

  /**
   * Every unordered pair is integrated once. `elements` run through closed curves with the body on their
   * left, with equal ends where they share a vertex; they may touch nowhere else.
   */
  KernelMatrices kernel_matrices(const std::vector<BoundaryElement> &elements, unsigned int degree,
                                 const GalerkinRule &rule);
} // namespace abut
