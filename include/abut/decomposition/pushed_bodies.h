// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/motion_terms.h>

namespace abut
{
  /**
   * Contact only pushes. A body without loads that floats along a motion, and that overlap pushes along it,
   * has to be pushed back by other contact: else it moves away, and what it was to carry is zero. A body with
   * loads comes to rest where these are balanced.
   *
   * Throws UserError with the body and the motion where the parts that overlap cannot all press in balance.
   * `gap_integrals`: D_k g_k of all parts before contact acts, as far as known (prescribed displacements).
   */
  void refuse_pushed_bodies(const InterfaceProblem &problem, const MotionTerms &motions,
                            const Eigen::VectorXd &gap_integrals);
} // namespace abut
