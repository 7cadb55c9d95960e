// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_motions.h>
#include <abut/decomposition/penalty_sensitivity.h>
#include <abut/run/estimate.h>
#include <abut/run/model.h>
#include <abut/run/observer.h>
#include <abut/run/setup.h>

#include <memory>
#include <optional>

namespace abut
{
  /// What a pass has made of its mesh.
  struct PassOutcome
  {
    Solution solution;
    Estimation estimation;                ///< empty where nothing is estimated
    ErrorBudget budget;                   ///< likewise
    std::optional<PenaltyChange> penalty; ///< likewise
    CarriedState state;                   ///< what the next mesh is to start from
    Times times;
    BoundaryCost boundary; ///< seconds of all estimates, sizes of one
  };

  /// One pass of the algorithm: the contact on the present mesh, then the estimate.
  class Pass
  {
  public:
    virtual ~Pass() = default;
    /// The bodies are prepared. `carried`: from the mesh before; none in the first pass. Throws
    /// ComputationError, and UserError where contact cannot hold a body.
    virtual PassOutcome run(const std::optional<CarriedState> &carried, const RunObserver &observer) = 0;

    /// What a stop by the increment rule is worth, for the solution of the last pass; empty where the limit
    /// is not at hand.
    virtual std::optional<LimitDistance> limit_distance(const Solution &) const { return {}; }
    /// What it keeps from one pass for the next, beside what is carried over to new meshes.
    virtual void serialize(Archive &archive) { archive(goal_distance_); }
    /// Sentences on loads of the last pass that nothing holds (see HeldMotions).
    virtual std::vector<std::string> dropped_loads() const { return {}; }

  protected:
    explicit Pass(const Setup &setup) : setup_(setup), goal_distance_(setup.scene.tolerance) {}
    /// Adds the bodies, pairs and the estimate that belong to the outcome's iteration. `motions`: those that
    /// the iteration has amplitudes of; null where it has none.
    void evaluate(PassOutcome &outcome, const InterfaceMotions *motions);

    /// What the penalty changes of a solution with these pressures; empty where that is not at hand or no
    /// error.
    virtual std::optional<PenaltyChange> penalty_change(const Eigen::VectorXd & /*pressures*/) const
    {
      return {};
    }

    const Setup setup_;

  private:
    GoalDistance goal_distance_;
  };

  /// The pass that a scene asks for. All of the setup must outlive it.
  std::unique_ptr<Pass> make_pass(const Setup &setup);
} // namespace abut
