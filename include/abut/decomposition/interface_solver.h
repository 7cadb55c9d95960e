// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/contact_system.h>
#include <abut/decomposition/held_parts.h>
#include <abut/decomposition/penalty_sensitivity.h>
#include <abut/decomposition/scheme.h>
#include <abut/scene/scheme_entry.h>

#include <memory>

namespace abut
{
  /**
   * The scheme that a scene asks for, with the compliance and the parameters that suit it, chosen once and
   * used for every load.
   */
  class InterfaceSolver
  {
  public:
    /// The problem must outlive the solver. Throws UserError where contact cannot hold a floating body.
    InterfaceSolver(const InterfaceProblem &problem, const DecompositionParameters &parameters);

    /// Begins from `start` where given, else from what the scheme guesses.
    /// Where the stopping rule is the bound, `tolerance` takes the place of the scene's.
    SchemeResult solve(const InterfaceProblem::Loads &loads, const std::optional<Eigen::VectorXd> &start,
                       const StepObserver &observer, const std::optional<double> &tolerance = {}) const;

    /// The limit of the iteration on the same mesh, to a bound of 1e-10. Not converged where that would take
    /// more than some ten seconds.
    SchemeResult limit(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &start) const;

    /// See abut::penalty_change.
    PenaltyChange penalty_change(const Eigen::VectorXd &pressures) const;

    const InterfaceCompliance &compliance() const { return *compliance_; }
    /// Null for a scheme that takes none.
    const MotionTerms *motions() const { return system_ ? &system_->motions : nullptr; }

  private:
    const InterfaceProblem &problem_;
    const SchemeEntry &entry_;
    DecompositionParameters parameters_; ///< as chosen for the problem
    std::unique_ptr<InterfaceCompliance> compliance_;
    std::unique_ptr<ContactSystem> system_; ///< of schemes that take motions
    std::optional<HeldParts> held_;         ///< with the system
  };
} // namespace abut
