// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/stress_samples.h>
#include <abut/results/step_estimate.h>
#include <abut/run/estimate.h>
#include <abut/run/model.h>

namespace abut
{
  /**
   * Estimates at single steps of the decomposition on one mesh: the bodies' displacement u^k against the
   * boundary elements' answer to the pressures p^k that the contact law makes of it.
   */
  class StepEstimates
  {
  public:
    /// All must outlive the object; `exact` may be null, `indicator` where nothing is asked.
    StepEstimates(const Scene &scene, const Model &model, const Indicator *indicator,
                  const ExactSolution *exact);

    /// Empty where the step's displacement is no field (the paper's literal guess).
    std::optional<StepEstimate> at(const StepRecord &record);

    /// What all of them have cost: seconds of the estimates, of comparing with the exact solution, and the
    /// boundary elements' part.
    double estimate_seconds() const { return estimate_seconds_; }
    double reference_seconds() const { return reference_seconds_; }
    const BoundaryCost &boundary_cost() const { return boundary_cost_; }

  private:
    std::vector<BodyResult> bodies_at(const StepRecord &record) const;
    /// Energy norm of the error, and of the exact stress.
    struct Norms
    {
      double error, exact;
    };
    std::optional<Norms> true_error(const std::vector<BodyResult> &bodies);

    const Scene &scene_;
    const Model &model_;
    const Indicator *indicator_;
    const ExactSolution *exact_;
    std::vector<std::vector<Stress>> exact_stresses_; ///< of every body, once asked for
    double estimate_seconds_ = 0., reference_seconds_ = 0.;
    BoundaryCost boundary_cost_;
  };
} // namespace abut
