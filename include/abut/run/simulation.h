// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/stopwatch.h>
#include <abut/run/checks/validity.h>
#include <abut/run/find_contacts.h>
#include <abut/run/pass.h>
#include <abut/run/run_state.h>

#include <memory>
#include <optional>

namespace abut
{
  /**
   * A scene from its description to its results: bodies and pairs are made and checked by the constructor
   * (UserError), then assembled, factorised and solved by `run`, on one mesh after the other where bodies
   * adapt.
   */
  class Simulation
  {
  public:
    /// The scene must outlive the simulation. Finds its contacts where it asks for that. `executor`: what
    /// several processes share a run by; they all make the simulation and run it.
    explicit Simulation(const Scene &scene, const Executor &executor = {});

    /// See abut::check_supports. Throws UserError.
    void check_supports() const;

    /// What is to be said of the input, before anything is solved.
    Warnings input_warnings() const { return abut::input_warnings(scene_, *model_); }

    /// Goes on from where a run of the same scene was: its meshes are made again, `run` begins with the next
    /// pass. A scene's run in a process of its own, or on another number of them, ends as if it had not been
    /// interrupted; what was there only in memory, the factors of bodies whose mesh stays, is made, and
    /// counted, once more. Before `run`. Throws UserError where other meshes come of it.
    void go_on_from(RunState state);

    /**
     * Solves; a second call goes on from the last mesh. Every pass solves the decomposition to
     * `Iteration fraction` of the estimated discretisation error, or takes one step of it (`Combined`, the
     * paper's Fig. 2), estimates, and adapts. Throws ComputationError. The results refer to this simulation.
     */
    Results run(const RunObserver &observer);

    /// Cells and unknowns of all bodies together.
    Counts counts() const { return model_->counts(); }

    const Executor &executor() const { return model_->executor(); }
    const Scene &scene() const { return scene_; }
    const std::vector<std::unique_ptr<Body>> &bodies() const { return model_->bodies(); }
    const std::vector<const ContactPair *> &pairs() const { return model_->pairs(); }

  private:
    Setup setup() const { return {scene_, *model_, indicator_.get(), certifier_.get(), exact_.get()}; }
    /// Prepares the bodies, then makes the pass.
    PassOutcome solve(Pass &pass, const std::optional<CarriedState> &carried, const RunObserver &observer);
    /// Adds the solution, record and times of a pass. `carried`: what it started from.
    void add(PassOutcome &outcome, const std::optional<CarriedState> &carried, Results &results) const;
    /// Tells the observer of a pass that was added.
    void show(const PassOutcome &outcome, const RunObserver &observer, Results &results) const;
    /// Makes the next mesh after a pass that was not the last, and notes what is carried over to it: nothing
    /// where no cell could be changed.
    void adapt(const PassOutcome &outcome, Results &results, RunState &state);
    /// Tells the observer of the state between two passes.
    void show(const Pass &pass, const RunObserver &observer, Results &results, RunState &state) const;

    const std::optional<Scene> completed_; ///< by the contacts that were found
    const Scene &scene_;
    WallClock clock_;
    Times construction_; ///< what the constructor took
    std::unique_ptr<ExactSolution> exact_;
    std::unique_ptr<Model> model_;
    std::unique_ptr<Indicator> indicator_, certifier_;
    RunState state_; ///< what `run` begins with
  };
} // namespace abut
