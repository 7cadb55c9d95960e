// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_system.h>
#include <abut/decomposition/scheme.h>

namespace abut
{
  /**
   * What the schemes that solve a ContactSystem share: what they know and what they report.
   *
   * Iteration error: the guaranteed bound where it applies and meets the tolerance, else the algebraic one
   * (see ContactResidual).
   */
  class ContactSystemScheme : public Scheme
  {
  public:
    /// The system must outlive the scheme.
    ContactSystemScheme(const ContactSystem &system, const DecompositionParameters &parameters)
        : system_(system), parameters_(parameters)
    {}

  protected:
    /// The result of pressures, their response without that to loads and motions, and amplitudes of the held
    /// motions, with its iteration error. `message` is left empty.
    SchemeResult result_of(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                           const Eigen::VectorXd &amplitudes, const Eigen::VectorXd &pressure_response) const;

    const ContactSystem &system_;
    const DecompositionParameters parameters_;
  };
} // namespace abut
