// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/checksum.h>
#include <abut/base/processes.h>
#include <abut/base/user_error.h>
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

#include <utility>

namespace abut
{
  namespace
  {
    void refuse_different_scenes(const Scene &scene, const Executor &executor)
    {
      if (executor.n_processes() == 1)
        return;
      constexpr std::uint64_t comparing_scenes = 17; // a meeting
      const auto checksums = executor.processes()->collect(comparing_scenes, [&]() {
        std::vector<std::string> own = {checksum(scene.parameters.data(), scene.parameters.size())};
        for (const std::string &file : scene.mesh_files())
          own.push_back(file_checksum(file));
        return own;
      });
      for (std::size_t rank = 1; rank < checksums.size(); ++rank)
        if (checksums[rank] != checksums.front())
          throw UserError(
              "the processes 0 and " + std::to_string(rank) + " of this run have read different " +
              (checksums[rank].front() != checksums.front().front() ? "parameters" : "mesh files") +
              "; give all of them the same files and options");
    }
  } // namespace

  Simulation::Simulation(const Scene &scene, const Executor &executor)
      : completed_(with_found_contacts(scene)), scene_(completed_ ? *completed_ : scene)
  {
    refuse_different_scenes(scene_, executor);
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
      model_->executor().of_bodies(bodies().size(), [&](const std::size_t a) {
        if (!bodies()[a]->description().is_rigid)
          indicator_->check(*bodies()[a]);
        return 0;
      });
  }

  void Simulation::check_supports() const
  {
    abut::check_supports(scene_, *model_);
  }

  namespace
  {
    bool fits(const CarriedState &carried, const Model &model)
    {
      for (std::size_t a = 0; a < model.bodies().size(); ++a)
        if (static_cast<std::size_t>(carried.displacements[a].size()) != model.bodies()[a]->counts().dofs)
          return false;
      return carried.pressures.size() == model.problem().n_pressures();
    }
  } // namespace

  namespace
  {
    void check_processes(const Scene &scene, const unsigned int before, const unsigned int now)
    {
      for (const BodyDescription &body : scene.bodies)
        if (body.shares_mesh && before != now)
          throw UserError("--resume: received " + std::to_string(now) + " processes for a run that " +
                          std::to_string(before) + " began, but the mesh of body " + body.name +
                          " is distributed; go on with mpirun -np " + std::to_string(before));
    }
  } // namespace

  void Simulation::go_on_from(RunState state)
  {
    check_processes(scene_, state.n_processes, executor().n_processes());
    const Stopwatch watch(construction_.mesh);
    clock_.add(state.seconds);
    model_->adapt_again(state.marks, state.counters);
    if (state.carried && !fits(*state.carried, *model_))
      throw UserError("the meshes of the run were made again with other unknowns; go on with the program and "
                      "libraries that the run began with, or begin anew");
    state_ = std::move(state);
  }

  Results Simulation::run(const RunObserver &observer)
  {
    check_supports();
    RunState state = std::exchange(state_, {});
    Results results;
    results.scene = &scene_;
    results.passes = state.passes;
    results.times = construction_;
    results.times += state.times;
    results.n_processes = executor().n_processes();
    const std::unique_ptr<Pass> pass = make_pass(setup());
    if (state.carried)
      unpack(state.pass, *pass);
    do
    {
      if (observer.begin_pass)
        observer.begin_pass(static_cast<unsigned int>(results.passes.size()), counts());
      PassOutcome outcome = solve(*pass, state.carried, observer);
      add(outcome, state.carried, results);
      show(outcome, observer, results);
      adapt(outcome, results, state);
      if (state.carried)
        show(*pass, observer, results, state);
    } while (state.carried);
    if (exact_)
    {
      const Stopwatch watch(results.times.reference);
      add_exact_pressures(*exact_, scene_, results.pairs);
    }
    results.points = point_values(scene_, results.bodies, executor());
    results.limit_distance = pass->limit_distance(results);
    add_final_values(executor(), scene_.tells_condition, results.bodies);
    results.warnings = all_warnings(scene_, *model_, results, pass->dropped_loads());
    results.left_out = left_out(setup(), results);
    const std::vector<unsigned int> n_meshes = model_->n_meshes(); // now that all has been asked
    for (std::size_t a = 0; a < n_meshes.size(); ++a)
      results.bodies[a].n_meshes = n_meshes[a];
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

  void Simulation::adapt(const PassOutcome &outcome, Results &results, RunState &state)
  {
    state.carried.reset();
    if (!results.iteration.converged() || !(scene_.adapts() || scene_.has_tolerance()))
      return;
    results.adaptation_end = adaptation_end(setup(), results.iteration, results.passes);
    if (results.adaptation_end)
      return;
    const Stopwatch watch(results.times.adapt);
    std::vector<CellMarks> marks = mark_all(scene_, outcome.estimation, results, executor());
    Adapted adapted = model_->adapt(marks, outcome.state);
    if (adapted.some_mesh_changed || scene_.adaptation.combined)
    {
      state.marks.push_back(std::move(marks));
      state.carried = std::move(adapted.state);
    }
    else
      results.adaptation_end = no_cell_to_split(setup(), results.passes.back());
  }

  void Simulation::show(const Pass &pass, const RunObserver &observer, Results &results,
                        RunState &state) const
  {
    if (!observer.adapted)
      return;
    const Stopwatch watch(results.times.output);
    state.pass = packed(pass);
    state.passes = results.passes;
    state.counters =
        executor().of_bodies(bodies().size(), [&](const std::size_t a) { return bodies()[a]->counters(); });
    state.times = results.times;
    state.seconds = clock_.seconds();
    state.n_processes = executor().n_processes();
    observer.adapted(state);
  }
} // namespace abut
