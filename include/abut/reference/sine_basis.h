// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /**
   * Even pressure shapes on the contact [-a, a] that vanish at its ends like a square root,
   *   b_j(x) = sqrt(1 - t^2) U_2j(t) = sin((2j + 1) arccos t),   t = x/a,   j = 0 ... n-1,
   * continued evenly with the period 2l: the mirror images in the ends x = 0 and x = l of a layer between
   * rollers. Lengths are in any one unit; requires 0 < a < l.
   */
  class SineBasis
  {
  public:
    SineBasis(double half_width, double length, Eigen::Index size);

    double half_width() const { return half_width_; }
    double length() const { return length_; }
    Eigen::Index size() const { return quadrature_.cols(); }

    /// b_j(x); zero outside the contact.
    Eigen::RowVectorXd values(double x) const;

    /**
     * Cosine amplitudes of every b_j: row 0 the mean over the period, row k the factor of cos(k pi x/l),
     * k = 1 ... n_modes. The integral behind them is pi a (-1)^j (2j+1) J_{2j+1}(z)/z with z = k pi a/l.
     */
    Eigen::MatrixXd modes(Eigen::Index n_modes) const;

    /**
     * phi_j(x) = sum_{k>=1} m_kj cos(lambda_k x)/lambda_k with lambda_k = k pi/l and the amplitudes m_kj,
     * summed in closed form, for |x| <= l: the kernel -ln(2 sin(pi |x-s|/(2l)))/pi is split into the
     * logarithm, whose integrals against Chebyshev polynomials are known, and a smooth part integrated by
     * Gauss-Chebyshev.
     */
    Eigen::RowVectorXd potential(double x) const;

    /// Nodes x_q in (-a, a), and the matrix W with int b_j f dx = sum_q W_qj f(x_q) for smooth f.
    const Eigen::VectorXd &nodes() const { return nodes_; }
    const Eigen::MatrixXd &quadrature() const { return quadrature_; }

  private:
    double half_width_;
    double length_;
    Eigen::VectorXd nodes_;
    Eigen::MatrixXd quadrature_;
  };
} // namespace abut
