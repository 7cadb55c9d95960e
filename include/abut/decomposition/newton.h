// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/motion_terms.h>
#include <abut/decomposition/pressure_operator.h>
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
    NewtonScheme(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                 const MotionTerms &motions, const DecompositionParameters &parameters);

    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;

  private:
    const InterfaceProblem &problem_;
    const InterfaceCompliance &compliance_;
    const MotionTerms &motions_;
    DecompositionParameters parameters_;
    ContactResidual residual_;
  };

  /// The result of pressures and amplitudes of held motions, with its iteration error. `message` is left
  /// empty.
  SchemeResult contact_result(const InterfaceProblem &problem, const ContactResidual &residual,
                              const MotionTerms &motions, const InterfaceProblem::Loads &loads,
                              const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes,
                              const Eigen::VectorXd &pressure_response, double tolerance);
} // namespace abut
