// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/motion_terms.h>

namespace abut
{
  /// Pressures p >= 0 and amplitudes of the held motions to begin with.
  struct ContactGuess
  {
    Eigen::VectorXd pressures, motions;
  };

  /**
   * The solution for elastic layers in place of the bodies, from the same conditions of contact and balance,
   * and then, begun with that, the one for the model compliance, unless `model` is empty: half-planes' and
   * layers' behaviour in one, which brings the edge of the contact within a few nodes. Costs no solve of a
   * body.
   */
  ContactGuess guess_contact(const InterfaceProblem &problem, const MotionTerms &motions,
                             const InterfaceProblem::Loads &loads, const Eigen::MatrixXd &model);
} // namespace abut
