// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/schemes/contact_system_scheme.h>
#include <abut/decomposition/schemes/pivoting.h>

namespace abut
{
  /**
   * Primal-dual active set (semismooth Newton) on the interface problem, theta = 0 (exact contact) included;
   * see ActiveSetMethod. The first active set is that of guess_contact, or where the start's traction
   * presses. A step is one system on an active set; their number does not grow with 1/theta or with the
   * stiffness ratio of the bodies.
   */
  class NewtonScheme : public ContactSystemScheme
  {
  public:
    using ContactSystemScheme::ContactSystemScheme;

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;

  private:
    /// What a run of the active-set method found. A state that it has not finished may pull: what is
    /// reported answers the pressures that push.
    SchemeResult answer(const InterfaceProblem::Loads &loads, const PivotResult &pivots) const;
  };
} // namespace abut
