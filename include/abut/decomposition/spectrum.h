// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>

namespace abut
{
  /// Positive entries with all frequencies in them, the same in every run.
  Eigen::VectorXd probing_vector(Eigen::Index n);

  /**
   * lambda_max = 1 + mu_max / theta of the parallel Neumann scheme, where mu_max is the largest eigenvalue of
   * the interface compliance with respect to the weights D: the scheme contracts for gamma < gamma* = 2 /
   * lambda_max. With `active` only the multipliers that the contact law takes as active at these take part
   * (contact there alone), without it all of them. Lanczos' method with full orthogonalisation to a relative
   * residual of 1e-5, which is added: an upper estimate.
   */
  double largest_eigenvalue(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                            const Eigen::VectorXd *active = nullptr);
} // namespace abut
