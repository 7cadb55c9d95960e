// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/run/limit_distance.h>
#include <abut/run/rigid_side.h>
#include <abut/run/solved_pass.h>
#include <abut/run/step_estimates.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    /// Tells an observer of the steps of a pass, which may take several solutions, and of estimates at them.
    class StepTeller
    {
    public:
      StepTeller(const Setup &setup, const RunObserver &observer, Times &times)
          : every_(observer.estimate ? setup.scene.adaptation.estimate_steps : 0), observer_(observer),
            estimates_(setup, times)
      {}

      /// Of a solution that `watch` measures.
      void tell(const StepRecord &record, Stopwatch &watch)
      {
        StepRecord counted = record;
        counted.step += n_steps_;
        counted.answered = counted.applied = nullptr;
        if (observer_.step)
          observer_.step(counted);
        if (every_ == 0 || (counted.step - 1) % every_ != 0)
          return;
        if (const auto estimate = estimates_.at(record, watch))
          observer_.estimate(*estimate);
      }
      /// After a solution.
      void count(const unsigned int steps) { n_steps_ += steps; }
      unsigned int n_steps() const { return n_steps_; }
      const BoundaryCost &boundary_cost() const { return estimates_.boundary_cost(); }

    private:
      unsigned int every_, n_steps_ = 0;
      const RunObserver &observer_;
      StepEstimates estimates_;
    };

    CarriedState state_of(const Solution &solution)
    {
      CarriedState state{{}, solution.iteration.traction, solution.rigid_displacement};
      for (const BodyResult &body : solution.bodies)
        state.displacements.push_back(body.displacement);
      return state;
    }

    /// Seconds are those of all estimates, sizes those of the last.
    BoundaryCost boundary_cost(BoundaryCost cost, const BoundaryCost &of_steps, const BoundaryCost &last)
    {
      cost += of_steps;
      cost.elements = last.elements;
      cost.unknowns = last.unknowns;
      return cost;
    }
  } // namespace

  PassOutcome SolvedPass::run(const std::optional<CarriedState> &carried, const RunObserver &observer)
  {
    PassOutcome outcome;
    {
      const Stopwatch watch(outcome.times.solve);
      solver_ = std::make_unique<InterfaceSolver>(setup_.model.problem(), setup_.scene.decomposition);
    }
    std::optional<Eigen::VectorXd> start;
    if (carried)
      start = setup_.model.problem().law().project(carried->pressures);
    const double guess = carried ? carried->rigid_displacement : 0.;
    SchemeResult &iteration = outcome.solution.iteration;
    StepTeller teller(setup_, observer, outcome.times);
    for (std::optional<double> tolerance = first_tolerance(); tolerance; tolerance = next_tolerance(outcome))
    {
      {
        Stopwatch watch(outcome.times.interface);
        const auto tell = [&](const StepRecord &record) { teller.tell(record, watch); };
        solve_interface(start, guess, *tolerance, tell, outcome.solution);
      }
      teller.count(iteration.steps);
      start = iteration.traction;
      evaluate(outcome, solver_->motions() == nullptr ? nullptr : &solver_->motions()->all);
    }
    iteration.steps = teller.n_steps();
    outcome.solution.compliance_is_dense = solver_->compliance().is_dense();
    outcome.boundary =
        boundary_cost(outcome.boundary, teller.boundary_cost(), outcome.estimation.boundary_cost());
    outcome.state = state_of(outcome.solution);
    discretisation_ = outcome.estimation.discretisation();
    return outcome;
  }

  bool SolvedPass::follows_estimate() const
  {
    return setup_.scene.adapts() && body_with_resultant(setup_.model) == nullptr;
  }

  double SolvedPass::first_tolerance() const
  {
    const double asked = setup_.scene.decomposition.tolerance;
    if (!follows_estimate())
      return asked;
    return std::max(asked, .5 * setup_.scene.adaptation.iteration_fraction *
                               discretisation_); // a refined mesh has less
  }

  std::optional<double> SolvedPass::next_tolerance(const PassOutcome &outcome) const
  {
    const SchemeResult &iteration = outcome.solution.iteration;
    const double asked = setup_.scene.decomposition.tolerance;
    if (!follows_estimate() || !iteration.converged() ||
        (iteration.stopped_by != StoppedBy::bound && iteration.stopped_by != StoppedBy::residual) ||
        iteration.iteration_error <= asked)
      return {};
    const double allowed =
        std::max(asked, setup_.scene.adaptation.iteration_fraction * outcome.estimation.discretisation());
    if (iteration.iteration_error <= allowed)
      return {};
    return std::max(asked, .5 * allowed);
  }

  void SolvedPass::solve_interface(const std::optional<Eigen::VectorXd> &start, const double guess,
                                   const double tolerance, const StepObserver &observer,
                                   Solution &solution) const
  {
    if (body_with_resultant(setup_.model) != nullptr && solver_->motions() == nullptr)
    {
      RigidSideSolution solved =
          solve_with_resultant(setup_.model, *solver_, start, guess, tolerance, observer);
      solution.iteration = std::move(solved.iteration);
      solution.rigid_displacement = solved.displacement;
      return;
    }
    solution.iteration = solver_->solve(setup_.model.problem().loads(0.), start, observer, tolerance);
  }

  std::optional<PenaltyChange> SolvedPass::penalty_change(const Eigen::VectorXd &pressures) const
  {
    if (setup_.scene.reference.contact == ReferenceParameters::Contact::penalised)
      return {}; // the penalised problem's own solution is what is looked for
    return solver_->penalty_change(pressures);
  }

  std::optional<LimitDistance> SolvedPass::limit_distance(const Solution &solution) const
  {
    return abut::limit_distance(setup_.model.problem(), *solver_, solution);
  }

  std::vector<std::string> SolvedPass::dropped_loads() const
  {
    return solver_->motions() == nullptr ? std::vector<std::string>() : solver_->motions()->dropped_loads;
  }
} // namespace abut
