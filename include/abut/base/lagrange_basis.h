// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /**
   * Lagrange polynomials of degree 1 to 12 on [0, 1] whose nodes are the Gauss-Lobatto points: for degrees up
   * to 3 the trace of deal.II's FE_Q, for degrees 1 and 2 that of FE_SimplexP.
   */
  class LagrangeBasis
  {
  public:
    explicit LagrangeBasis(unsigned int degree);

    unsigned int degree() const { return static_cast<unsigned int>(nodes_.size()) - 1; }
    const Eigen::VectorXd &nodes() const { return nodes_; }

    /// Values of the degree + 1 polynomials at s.
    Eigen::VectorXd values(double s) const;
    /// Their derivatives at s.
    Eigen::VectorXd derivatives(double s) const;
    /// The integrals over [0, 1]: the weights of the Gauss-Lobatto rule.
    Eigen::VectorXd integrals() const;

  private:
    Eigen::VectorXd nodes_;
    Eigen::VectorXd scaling_; // 1 / prod_(j != i) (s_i - s_j)
  };

  /// Gauss-Legendre rule on [0, 1].
  struct GaussRule
  {
    explicit GaussRule(unsigned int n_points);

    /**
     * The same in t, s = sin^2(pi t/2): integrates as well what grows like the inverse square root at either
     * end, e.g. the pressure under the edge of a flat punch. Spectrally accurate for polynomials too.
     */
    static GaussRule for_singular_ends(unsigned int n_points);

    Eigen::VectorXd points;
    Eigen::VectorXd weights;
  };
} // namespace abut
