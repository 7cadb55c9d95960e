// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/schemes/contact_system_scheme.h>

namespace abut
{
  /**
   * Projected conjugate gradients on min_{p >= 0} p . (C + theta D) p / 2 + p . g, in the variables
   * sqrt(D_k) p_k; theta = 0 (exact contact) included. A step is one solve of every body; a dozen more
   * estimate the norm, and two or three for each proximal step measure the error. Motions of floating bodies
   * and rigid sides are eliminated by proximal steps as in ActiveSetMethod, which is the augmented Lagrangian
   * of the conditions of balance.
   */
  class ConjugateScheme : public ContactSystemScheme
  {
  public:
    using ContactSystemScheme::ContactSystemScheme;

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;
  };
} // namespace abut
