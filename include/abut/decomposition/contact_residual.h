// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>

namespace abut
{
  /// D_k sum_a 1/E_a: what half-planes yield under a load as wide as a part.
  Eigen::VectorXd part_softness(const InterfaceProblem &problem);

  /**
   * What is left of the contact law, as an iteration error: with w = g + theta p and the pressures t = p -
   * max(0, p - w / (theta + beta)), the energy norm sqrt(t . C t) of the displacement that t makes, by the
   * reference norm (see reference_norm).
   */
  class ContactResidual
  {
  public:
    /// Takes one product with the compliance. Both must outlive the object.
    ContactResidual(const InterfaceProblem &problem, const InterfaceCompliance &compliance);

    /// beta = 0, t = p - max(0, -g) / theta: bounds the distance from u_theta, as for the parallel Neumann
    /// scheme. Needs theta > 0 and no motions as unknowns.
    double guaranteed(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                      const Eigen::VectorXd &pressure_response, const Eigen::VectorXd &response) const;

    /**
     * beta_k = s_k D_k, where s_k = a . C a / |D a|^2, taken over part k and two neighbours on both sides, is
     * what the bodies yield under pressures a that alternate from part to part (at most what
     * half-planes yield): an algebraic error, also for theta = 0. No bound, but on the safe side: right where
     * C is smallest, for errors that alternate, and too large by up to 4 H/h, or by what a stiff fine slave
     * yields less than its master, for smooth ones (a test compares).
     */
    double algebraic(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                     const Eigen::VectorXd &pressure_response, const Eigen::VectorXd &response) const;

  private:
    /// t.
    Eigen::VectorXd residual(const Eigen::VectorXd &pressures, const Eigen::VectorXd &response,
                             const Eigen::VectorXd &beta) const;
    double relative(const Eigen::VectorXd &residual, const InterfaceProblem::Loads &loads,
                    const Eigen::VectorXd &pressures, const Eigen::VectorXd &pressure_response) const;

    const InterfaceProblem &problem_;
    const InterfaceCompliance &compliance_;
    Eigen::VectorXd beta_;
  };
} // namespace abut
