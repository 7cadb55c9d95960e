// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_system.h>
#include <abut/decomposition/scheme.h>

namespace abut
{
  /**
   * Primal-dual active set (semismooth Newton) on the interface problem, theta = 0 (exact contact) included;
   * see ActiveSetMethod. The first active set is that of guess_contact, or where the start's traction
   * presses. A step is one system on an active set; their number does not grow with 1/theta or with the
   * stiffness ratio of the bodies.
   *
   * Iteration error: the guaranteed bound where it applies and meets the tolerance, else the algebraic one
   * (see ContactResidual).
   */
  class NewtonScheme : public Scheme
  {
  public:
    /// The system must outlive the scheme.
    NewtonScheme(const ContactSystem &system, const DecompositionParameters &parameters)
        : system_(system), parameters_(parameters)
    {}

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;

  private:
    const ContactSystem &system_;
    DecompositionParameters parameters_;
  };

  /// The result of pressures and amplitudes of held motions, with its iteration error. `message` is left
  /// empty.
  SchemeResult contact_result(const ContactSystem &system, const InterfaceProblem::Loads &loads,
                              const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes,
                              const Eigen::VectorXd &pressure_response, double tolerance);
} // namespace abut
