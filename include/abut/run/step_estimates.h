// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/stopwatch.h>
#include <abut/comparison/stress_samples.h>
#include <abut/decomposition/scheme.h>
#include <abut/results/step_estimate.h>
#include <abut/run/estimate.h>

namespace abut
{
  /**
   * Estimates at single steps of the decomposition on one mesh: the bodies' displacement u^k against the
   * boundary elements' answer to the pressures p^k that the contact law makes of it.
   */
  class StepEstimates
  {
  public:
    /// All must outlive the object. Estimates and comparisons with the exact solution count to `times`.
    StepEstimates(const Setup &setup, Times &times) : setup_(setup), times_(times) {}

    /// Empty where the step's displacement is no field (the paper's literal guess). `solving` measures the
    /// solution that the step belongs to, and stands still meanwhile. The setup has an indicator.
    std::optional<StepEstimate> at(const StepRecord &record, Stopwatch &solving);

    /// The boundary elements' part of what all of them have cost.
    const BoundaryCost &boundary_cost() const { return boundary_cost_; }

  private:
    std::vector<BodyResult> bodies_at(const StepRecord &record) const;
    /// Energy norm of the error, and of the exact stress.
    struct Norms
    {
      double error = 0., exact = 0.;

      void serialize(Archive &archive) { archive(error, exact); }
    };
    /// Their squares on a body. `exact_stresses`: at its samples, which are found once.
    static Norms squares(const BodyResult &body, const OwnStress &stress,
                         std::vector<Stress> &exact_stresses);
    std::optional<Norms> true_error(const std::vector<BodyResult> &bodies);

    const Setup setup_;
    Times &times_;
    std::vector<std::vector<Stress>> exact_stresses_; ///< of every body, once asked for
    BoundaryCost boundary_cost_;
  };
} // namespace abut
