// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_system.h>

#include <optional>

namespace abut
{
  /// Pressures p >= 0 and amplitudes of the held motions to begin with.
  struct ContactGuess
  {
    Eigen::VectorXd pressures, motions;
  };

  /**
   * The solution for elastic layers in place of the bodies, from the same conditions of contact and balance,
   * and then, begun with that, the one for the model compliance, which knows half-planes as well. Costs no
   * solve of a body. With `pressures` given, those are taken, and only motions are guessed.
   */
  ContactGuess guess_contact(const ContactSystem &system, const InterfaceProblem::Loads &loads,
                             const std::optional<Eigen::VectorXd> &pressures);
} // namespace abut
