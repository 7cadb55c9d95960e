// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/true_errors.h>
#include <abut/run/adaptation_end.h>
#include <abut/run/checks/supports.h>
#include <abut/run/estimate.h>
#include <abut/run/evaluate.h>
#include <abut/run/goal_value.h>
#include <abut/run/left_out.h>
#include <abut/run/pass_record.h>
#include <abut/run/point_values.h>
#include <abut/run/simulation.h>

namespace abut
{
  Simulation::Simulation(const Scene &scene, const Executor &executor)
      : completed_(with_found_contacts(scene)), scene_(completed_ ? *completed_ : scene)
  {
    {
      const Stopwatch watch(construction_.reference);
      exact_ = make_exact_solution(scene_);
    }
    const Stopwatch watch(construction_.mesh);
    model_ = std::make_unique<Model>(scene_, exact_.get(), executor);
    check_goal(scene_, *model_);
    check_output_points(scene_, *model_);
    indicator_ = make_indicator(scene_.adaptation);
    certifier_ = make_certifier(scene_.adaptation);
    if (indicator_)
      for (const auto &body : bodies())
        if (!body->description().is_rigid)
          indicator_->check(*body);
  }

  void Simulation::check_supports() const
  {
    abut::check_supports(scene_, *model_);
  }

  Results Simulation::run(const RunObserver &observer)
  {
    check_supports();
    Results results;
    results.scene = &scene_;
    results.times = construction_;
    results.n_processes = executor().n_processes();
    const std::unique_ptr<Pass> pass = make_pass(setup());
    std::optional<CarriedState> carried; // from the mesh before
    do
    {
      if (observer.begin_pass)
        observer.begin_pass(static_cast<unsigned int>(results.passes.size()), counts());
      PassOutcome outcome = solve(*pass, carried, observer);
      add(outcome, carried, results);
      show(outcome, observer, results);
      carried = adapt(outcome, results);
    } while (carried);
    if (exact_)
    {
      const Stopwatch watch(results.times.reference);
      add_exact_pressures(*exact_, scene_, results.pairs);
    }
    results.points = point_values(scene_, results.bodies);
    results.limit_distance = pass->limit_distance(results);
    add_final_values(executor(), scene_.tells_condition, results.bodies);
    results.warnings = all_warnings(scene_, *model_, results, pass->dropped_loads());
    results.left_out = left_out(setup(), results);
    return results;
  }

  PassOutcome Simulation::solve(Pass &pass, const std::optional<CarriedState> &carried,
                                const RunObserver &observer)
  {
    const PreparationTimes preparation = model_->prepare();
    PassOutcome outcome = pass.run(carried, observer);
    outcome.times.assemble = preparation.assemble;
    outcome.times.factorise = preparation.factorise;
    outcome.times.bem = outcome.boundary.seconds();
    return outcome;
  }

  void Simulation::add(PassOutcome &outcome, const std::optional<CarriedState> &carried,
                       Results &results) const
  {
    PassRecord record = record_pass(setup(), outcome, carried);
    record.pass = static_cast<unsigned int>(results.passes.size());
    if (scene_.has_tolerance() && !results.passes.empty())
      correct_by_change(results.passes.back(), record);
    if (!scene_.goal.is_energy())
      record.goal = goal_record(setup(), outcome.solution, outcome.penalty, results.passes);
    if (exact_)
    {
      const Stopwatch watch(outcome.times.reference);
      compare_with_exact(setup(), outcome, record);
    }
    results.times += outcome.times;
    record.seconds = clock_.seconds() - results.times.reference - results.times.output;
    results.true_errors = record.true_errors;
    results.passes.push_back(std::move(record));
    static_cast<Solution &>(results) = std::move(outcome.solution);
  }

  void Simulation::show(const PassOutcome &outcome, const RunObserver &observer, Results &results) const
  {
    const Stopwatch watch(results.times.output);
    if (observer.end_pass)
      observer.end_pass(results.passes.back());
    if (observer.state)
      observer.state({results, outcome.estimation, model_->problem()});
  }

  std::optional<CarriedState> Simulation::adapt(const PassOutcome &outcome, Results &results)
  {
    if (!results.iteration.converged() || !(scene_.adapts() || scene_.has_tolerance()))
      return {};
    results.adaptation_end = adaptation_end(setup(), results.iteration, results.passes);
    if (results.adaptation_end)
      return {};
    const Stopwatch watch(results.times.adapt);
    Adapted adapted = model_->adapt(mark_all(scene_, outcome.estimation, results), outcome.state);
    if (adapted.some_mesh_changed || scene_.adaptation.combined)
      return std::move(adapted.state);
    results.adaptation_end = no_cell_to_split(setup(), results.passes.back());
    return {};
  }
} // namespace abut
