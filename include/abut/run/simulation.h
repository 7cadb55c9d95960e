// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_solver.h>
#include <abut/results/step_estimate.h>
#include <abut/run/checks/validity.h>
#include <abut/run/estimate.h>
#include <abut/run/model.h>

#include <chrono>
#include <iosfwd>
#include <memory>

namespace abut
{
  /// A pass as it stands, before the mesh changes; valid during the call that shows it.
  struct PassState
  {
    const Results &results;
    const Estimation &estimation; ///< empty where nothing is estimated
    const InterfaceProblem &problem;
  };

  /// Is told what happens in a run; each part may be empty.
  struct RunObserver
  {
    std::function<void(unsigned int pass, const Counts &counts)> begin_pass;
    StepObserver step;
    std::function<void(const StepEstimate &)> estimate; ///< after its step (Adaptation/Estimate steps)
    std::function<void(const PassRecord &)> end_pass;
    std::function<void(const PassState &)> state; ///< after end_pass
  };

  /**
   * A scene from its description to its results: bodies and pairs are made and checked by the constructor
   * (UserError), then assembled, factorised and solved by `run`, on one mesh after the other where bodies
   * adapt.
   */
  class Simulation
  {
  public:
    /// The scene must outlive the simulation.
    explicit Simulation(const Scene &scene);

    /// What will be solved: bodies, unknowns, supports, rigid motions left free, gaps, penalties.
    void describe(std::ostream &out) const;

    /// Throws UserError for a body whose supports leave a rigid motion free which the scheme cannot find, or
    /// which contact cannot hold or pushes away, and where supports press both bodies of a pair into each
    /// other.
    void check_supports() const;

    /// What is to be said of the input, before anything is solved.
    Warnings input_warnings() const { return abut::input_warnings(scene_, *model_); }

    /**
     * Solves; a second call goes on from the last mesh. Every pass solves the decomposition to
     * `Iteration fraction` of the estimated discretisation error, or takes one step of it (`Combined`, the
     * paper's Fig. 2), estimates, and adapts. Throws ComputationError. The results refer to this simulation.
     */
    Results run(const RunObserver &observer);

    /// Cells and unknowns of all bodies together.
    Counts counts() const { return model_->counts(); }

    const std::vector<std::unique_ptr<Body>> &bodies() const { return model_->bodies(); }
    const std::vector<const ContactPair *> &pairs() const { return model_->pairs(); }

  private:
    void check_held_points() const;
    /// As far as the bodies move without deforming.
    void check_pushed_bodies(const MotionTerms &motions) const;
    /// Solves the decomposition on the present mesh and estimates; returns what the next mesh is to start
    /// from.
    CarriedState solve_pass(const std::optional<CarriedState> &carried, const RunObserver &observer,
                            Results &results);
    /// (20)-(21) once, and the estimate.
    CarriedState take_combined_step(const std::optional<CarriedState> &carried, const RunObserver &observer,
                                    Results &results);
    /// What is wrong where gamma is too large for the test that has ended the passes to mean anything.
    std::string combined_accident(const Results &results) const;
    /// What to add to a message where gamma is too large for contact on the whole side; else empty.
    std::string relaxation_hint() const;
    CarriedState initial_state(const InterfaceProblem::Loads &loads);

    double first_tolerance(const Results &results) const;
    bool iterated_enough(const Results &results, double &tolerance) const;
    SchemeResult solve_interface(const std::optional<Eigen::VectorXd> &start, double tolerance,
                                 const StepObserver &observer, Results &results) const;
    /// The same where the displacement of the rigid side is found by a secant method.
    SchemeResult solve_with_resultant(const Body &pressed, const std::optional<Eigen::VectorXd> &start,
                                      double tolerance, const StepObserver &observer, Results &results) const;
    /// The body with a rigid side that carries a given force, or none.
    const Body *resultant_body() const;

    /// Bodies, pairs and estimates that belong to the traction of `results.iteration`.
    void evaluate(Results &results);
    void count_boundary_elements(const BoundaryCost &cost, Results &results);
    PassRecord record_pass(const std::optional<CarriedState> &carried, Results &results) const;
    /// Whether no further mesh is to be made; then `results.adaptation_end` says why, in a scene that adapts.
    bool is_last_pass(Results &results) const;
    /// Empty where no limit was asked for or eta is below it, else one sentence that begins with the cause.
    std::string limit_message(const Results &results, const std::string &cause) const;
    bool adapts() const;
    /// Makes the next mesh. Empty where no cell could be changed.
    std::optional<CarriedState> adapt(const CarriedState &state, Results &results);

    BodyResult body_result(std::size_t index, const Results &results) const;
    PairResult pair_result(std::size_t index, const Results &results) const;
    /// Throws ComputationError where they are not finite.
    static void find_all_peaks(Results &results);
    /// What a stop by the increment rule is worth; empty where the limit is not at hand.
    std::optional<LimitDistance> limit_distance(const Results &results) const;
    Warnings scheme_warnings() const;
    Warnings estimator_warnings() const;
    Warnings warnings(const Results &results) const;
    /// What this scene did not need.
    std::vector<std::string> left_out(const Results &results) const;

    const Scene &scene_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::unique_ptr<ExactSolution> exact_;
    std::unique_ptr<Model> model_;
    std::unique_ptr<Indicator> indicator_;
    std::unique_ptr<InterfaceSolver> solver_; ///< of the present mesh
    Estimation estimation_;                   ///< of the present solution
    PassCost cost_;                           ///< of the present pass
    bool state_is_field_ = true; ///< combined algorithm: false after the paper's literal initial guess
    double mesh_time_ = 0., reference_time_ = 0.;
  };
} // namespace abut
