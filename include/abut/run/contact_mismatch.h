// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/law_mismatch.h>
#include <abut/decomposition/interface_problem.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>

namespace abut
{
  /// Of one pair, of the bodies' displacements and their `estimate_forces`. `near`: see law_mismatch.
  LawMismatch mismatch_of(const ContactPair &pair, const std::vector<bool> &near,
                          const std::vector<BodyResult> &bodies);

  /// Of all pairs. The pressures of all parts make the `estimate_forces`.
  ContactMismatch contact_mismatch(const InterfaceProblem &problem, const Eigen::VectorXd &pressures,
                                   const std::vector<BodyResult> &bodies);
} // namespace abut
