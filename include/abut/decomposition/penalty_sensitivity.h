// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>
#include <abut/decomposition/motion_terms.h>

namespace abut
{
  /// What a penalty changes of a solution; sizes.
  struct PenaltyChange
  {
    double energy = 0.;        ///< squared energy norm
    double force = 0.;         ///< of the sum of D_k p_k
    Eigen::VectorXd pressures; ///< of all parts
  };

  /**
   * How far a solution of the penalised problem is from that without a penalty, u_theta - u_0, by the first
   * four terms of the expansion in theta with the parts in contact kept, p_0 = p and (C + theta D) p_k+1 =
   * theta D p_k,   dp = p_1 + ... + p_4, whose squared energy norm is dp . C dp; with motions that contact
   * holds in balance. `pressures`: of the solution. `motions`: null where the scheme takes none. Zero without
   * a penalty. Throws ComputationError.
   */
  PenaltyChange penalty_change(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const MotionTerms *motions, const Eigen::VectorXd &pressures);
} // namespace abut
