// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /**
   * The square root of a Laplacian in one dimension, by tridiagonal solves. On parts that follow one another
   * along a line, with their widths as the matrix M and the differences K between neighbours, ends free,
   *
   *     A = M^-1 K + diag(kappa^2),   A^-1/2 = 1/pi int_0^infinity (A + t)^-1 t^-1/2 dt,
   *
   * with the trapezoidal rule in log t [BonitoPasciak2015]: some ten solves where the eigenvalues of A span
   * six powers of ten. A half-plane yields to pressures as A^-1/2 with kappa = 0, a body of finite depth as
   * with kappa > 0, whose inverse is its depth by two.
   */
  class HalfLaplacian
  {
  public:
    /// `places`: increasing along the line, a length; `widths` > 0, a length; `kappas` > 0, one by a length.
    HalfLaplacian(const Eigen::VectorXd &places, Eigen::VectorXd widths, const Eigen::VectorXd &kappas);

    /// M A^-1/2 v, within 2 %: a symmetric positive definite matrix times v.
    Eigen::VectorXd integrals(const Eigen::VectorXd &values) const;
    /// (A^-1/2 + softness)^-1 M^-1 r, within 4 %, likewise. `softness` >= 0, a length.
    Eigen::VectorXd solve(const Eigen::VectorXd &integrals, double softness) const;

  private:
    /// (K + M (kappa^2 + shift))^-1 b.
    Eigen::VectorXd shifted_solve(double shift, const Eigen::VectorXd &right_side) const;
    /// Sum of weight(t) (A + t)^-1 M^-1 b, for weights that matter from exp(lowest) on.
    template <typename Weight>
    Eigen::VectorXd sum_of_solves(const Weight &weight, double lowest,
                                  const Eigen::VectorXd &right_side) const;

    Eigen::VectorXd widths_;
    Eigen::VectorXd links_;    ///< -K(i, i + 1) > 0
    Eigen::VectorXd diagonal_; ///< of K + M kappa^2
    double lowest_, highest_;  ///< logarithms that enclose the eigenvalues of A
  };
} // namespace abut
