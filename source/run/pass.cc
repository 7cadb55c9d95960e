// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/run/budget.h>
#include <abut/run/combined_pass.h>
#include <abut/run/estimate.h>
#include <abut/run/evaluate.h>
#include <abut/run/solved_pass.h>

namespace abut
{
  void Pass::evaluate(PassOutcome &outcome, const InterfaceMotions *const motions)
  {
    Solution &solution = outcome.solution;
    {
      const Stopwatch watch(outcome.times.solve);
      solution.bodies = body_results(setup_.model, solution.iteration, solution.rigid_displacement, motions);
    }
    solution.pairs = pair_results(setup_.model, solution.iteration, solution.bodies);
    if (setup_.indicator == nullptr)
      return;
    const Stopwatch watch(outcome.times.estimate);
    outcome.estimation = estimate_solution(setup_, solution, goal_distance_);
    outcome.boundary += outcome.estimation.boundary_cost();
    outcome.penalty = penalty_change(solution.iteration.traction);
    outcome.budget = error_budget(setup_.model.executor(), solution, outcome.estimation, outcome.penalty);
  }

  std::unique_ptr<Pass> make_pass(const Setup &setup)
  {
    if (setup.scene.adaptation.combined)
      return std::make_unique<CombinedPass>(setup);
    return std::make_unique<SolvedPass>(setup);
  }
} // namespace abut
