// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>

namespace abut
{
  /// beta_i = D_i sum_a 1/E_a: what half-planes yield under a load as wide as a node.
  Eigen::VectorXd node_softness(const InterfaceProblem &problem);

  /**
   * What is left of the contact law, as an iteration error: with w = g + theta p and the pressures t = p -
   * max(0, p - w / (theta + beta)), the energy norm sqrt(t . C t) of the displacement that t makes, by the
   * reference norm (see reference_norm).
   *
   * `guaranteed`: beta = 0, t = p - max(0, -g) / theta; then it bounds the distance from u_theta, as for the
   * parallel Neumann scheme. Needs theta > 0 and no motions as unknowns.
   *
   * Otherwise beta_i = D_i sum_a 1/E_a, what a half-plane yields under a load as wide as a node: an algebraic
   * error, also for theta = 0. No bound, but on the safe side: right for errors that alternate from node to
   * node, too large by up to H/h for smooth ones (a test compares).
   */
  double contact_residual(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                          const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                          const Eigen::VectorXd &pressure_response, const Eigen::VectorXd &response,
                          bool guaranteed);
} // namespace abut
