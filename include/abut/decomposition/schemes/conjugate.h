// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_system.h>
#include <abut/decomposition/scheme.h>

namespace abut
{
  /**
   * Projected conjugate gradients on min_{p >= 0} p . (C + theta D) p / 2 + p . g, in the variables
   * sqrt(D_k) p_k; theta = 0 (exact contact) included. A step is one solve of every body; a dozen more
   * estimate the norm, and two or three for each proximal step measure the error. Motions of floating bodies
   * and rigid sides are eliminated by proximal steps as in ActiveSetMethod, which is the augmented Lagrangian
   * of the conditions of balance.
   *
   * Iteration error: as for the scheme newton.
   */
  class ConjugateScheme : public Scheme
  {
  public:
    /// The system must outlive the scheme.
    ConjugateScheme(const ContactSystem &system, const DecompositionParameters &parameters)
        : system_(system), parameters_(parameters)
    {}

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;

  private:
    const ContactSystem &system_;
    DecompositionParameters parameters_;
  };
} // namespace abut
