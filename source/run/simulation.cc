// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/base/user_error.h>
#include <abut/decomposition/pushed_bodies.h>
#include <abut/decomposition/resultant_loading.h>
#include <abut/run/simulation.h>
#include <abut/run/step_estimates.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  Simulation::Simulation(const Scene &scene) : scene_(scene)
  {
    {
      const Stopwatch watch(reference_time_);
      exact_ = make_exact_solution(scene);
    }
    const Stopwatch watch(mesh_time_);
    model_ = std::make_unique<Model>(scene, exact_.get());
    indicator_ = make_indicator(scene.adaptation.estimator, scene.adaptation.boundary_solution);
    if (indicator_)
      for (const auto &body : bodies())
        indicator_->check(*body);
  }

  void Simulation::check_supports() const
  {
    check_held_points();
    bool floats = false;
    for (const auto &body : bodies())
    {
      if (body->free_rigid_motions().empty())
        continue;
      std::string motions;
      for (const std::string &motion : body->free_rigid_motions())
        motions += (motions.empty() ? "" : ", ") + motion;
      if (body->contact_sides().empty())
        throw UserError("Body " + body->name() + " is held by nothing against " + motions +
                        ": give it supports in Body " + body->name() +
                        "/Conditions (a displacement condition on a side or at a point)");
      if (scene_.decomposition.scheme == SchemeKind::neumann)
        throw UserError("Body " + body->name() + " is held by contact alone against " + motions +
                        ": Decomposition/Scheme = neumann needs supports on every body; take newton or "
                        "conjugate, or add a displacement condition to Body " +
                        body->name() + "/Conditions");
      floats = true;
    }
    if (floats &&
        resultant_body() == nullptr) // rigid sides need the stiffness: those scenes are checked later
      check_pushed_bodies(make_motion_terms(model_->problem()));
  }

  void Simulation::check_pushed_bodies(const MotionTerms &motions) const
  {
    std::vector<Eigen::VectorXd> prescribed;
    for (const auto &body : bodies())
      prescribed.push_back(body->prescribed_trace());
    const InterfaceProblem &problem = model_->problem();
    refuse_pushed_bodies(problem, motions, problem.observe(prescribed).head(problem.n_pressures()));
  }

  void Simulation::check_held_points() const
  {
    const auto prescribed = [&](const ContactBody &side) -> Eigen::VectorXd {
      const Body &body = *bodies()[side.body];
      return body.prescribed_trace().segment(body.trace_offset(side.side),
                                             static_cast<Eigen::Index>(2 * side.trace->n_nodes()));
    };
    for (const ContactPair *pair : pairs())
    {
      if (pair->penalty() > 0.)
        continue;
      const auto found = pair->held_overlap(prescribed(pair->cut_side()), prescribed(pair->other_side()));
      if (!found)
        continue;
      std::ostringstream text;
      text << "Contact " << pair->name() << ": at (" << found->place.x() << ", " << found->place.y()
           << ") supports hold both bodies, and make them overlap by " << found->overlap
           << ", which no pressure can undo; let the contact side end before the held nodes, or give the "
              "contact "
              "a Penalty coefficient";
      throw UserError(text.str());
    }
  }

  Results Simulation::run(const RunObserver &observer)
  {
    check_supports();
    Results results;
    results.scene = &scene_;
    results.times.mesh = mesh_time_;
    results.times.reference = reference_time_;
    std::optional<CarriedState> carried; // from the mesh before
    for (unsigned int pass = 0;; ++pass)
    {
      if (observer.begin_pass)
        observer.begin_pass(pass, counts());
      const Times before = results.times;
      cost_ = {};
      model_->prepare(results.times);
      const CarriedState state = scene_.adaptation.combined ? take_combined_step(carried, observer, results)
                                                            : solve_pass(carried, observer, results);
      cost_.assemble = results.times.assemble - before.assemble;
      cost_.factorise = results.times.factorise - before.factorise;
      cost_.solve = results.times.solve - before.solve;
      results.passes.push_back(record_pass(carried, results));
      if (observer.end_pass)
        observer.end_pass(results.passes.back());
      if (observer.state)
        observer.state({results, estimation_, model_->problem()});
      if (is_last_pass(results))
        break;
      carried = adapt(state, results);
      if (!carried)
        break;
    }
    find_all_peaks(results);
    results.limit_distance = limit_distance(results);
    results.warnings = warnings(results);
    results.left_out = left_out(results);
    return results;
  }

  CarriedState Simulation::solve_pass(const std::optional<CarriedState> &carried, const RunObserver &observer,
                                      Results &results)
  {
    {
      const Stopwatch watch(results.times.solve);
      solver_ = std::make_unique<InterfaceSolver>(model_->problem(), scene_.decomposition);
    }
    std::optional<Eigen::VectorXd> start;
    if (carried)
      start = carried->pressures.cwiseMax(0.);
    double tolerance = first_tolerance(results);
    unsigned int steps = 0;
    const unsigned int every = scene_.adaptation.estimate_steps;
    StepEstimates estimates(scene_, *model_, indicator_.get(), exact_.get());
    const auto count_on = [&](const StepRecord &record) {
      StepRecord counted = record;
      counted.step += steps;
      counted.answered = counted.applied = nullptr;
      if (observer.step)
        observer.step(counted);
      if (every > 0 && observer.estimate && (counted.step - 1) % every == 0)
        if (const auto estimate = estimates.at(record))
          observer.estimate(*estimate);
    };
    do
    {
      {
        const Stopwatch watch(results.times.interface);
        results.iteration = solve_interface(start, tolerance, count_on, results);
      }
      steps += results.iteration.steps;
      start = results.iteration.traction;
      evaluate(results);
    } while (!iterated_enough(results, tolerance));
    results.compliance_is_dense = solver_->compliance().is_dense();
    results.times.interface -= estimates.estimate_seconds() + estimates.reference_seconds();
    results.times.estimate += estimates.estimate_seconds();
    results.times.reference += estimates.reference_seconds();
    count_boundary_elements(estimates.boundary_cost(), results);
    results.iteration.steps = steps;

    CarriedState state;
    for (const BodyResult &body : results.bodies)
      state.displacements.push_back(body.displacement);
    state.pressures = results.iteration.traction;
    return state;
  }

  double Simulation::first_tolerance(const Results &results) const
  {
    constexpr double first_guess = .1; // of the discretisation error
    const double asked = scene_.decomposition.tolerance, share = scene_.adaptation.iteration_fraction;
    if (!adapts() || resultant_body() != nullptr)
      return asked;
    const double last = results.passes.empty() ? first_guess : results.passes.back().discretisation.value();
    return std::max(asked, .5 * share * last); // a refined mesh has less
  }

  /// Whether the iteration error has its share of the discretisation error; else sets the tolerance anew.
  bool Simulation::iterated_enough(const Results &results, double &tolerance) const
  {
    const SchemeResult &iteration = results.iteration;
    const double asked = scene_.decomposition.tolerance, share = scene_.adaptation.iteration_fraction;
    if (!adapts() || resultant_body() != nullptr || !iteration.converged() ||
        (iteration.stopped_by != StoppedBy::bound && iteration.stopped_by != StoppedBy::residual) ||
        iteration.iteration_error <= asked)
      return true;
    const double allowed = std::max(asked, share * estimation_.discretisation());
    tolerance = std::max(asked, .5 * allowed);
    return iteration.iteration_error <= allowed;
  }

  const Body *Simulation::resultant_body() const
  {
    for (const auto &body : bodies())
      if (body->resultant())
        return body.get();
    return nullptr;
  }

  SchemeResult Simulation::solve_interface(const std::optional<Eigen::VectorXd> &start,
                                           const double tolerance, const StepObserver &observer,
                                           Results &results) const
  {
    const Body *const pressed = resultant_body();
    if (pressed != nullptr && scene_.decomposition.scheme == SchemeKind::neumann)
      return solve_with_resultant(*pressed, start, tolerance, observer, results);
    return solver_->solve(model_->problem().loads(0.), start, observer, tolerance);
  }

  SchemeResult Simulation::solve_with_resultant(const Body &pressed,
                                                const std::optional<Eigen::VectorXd> &start,
                                                const double tolerance, const StepObserver &observer,
                                                Results &results) const
  {
    const InterfaceProblem &problem = model_->problem();
    std::optional<Eigen::VectorXd> from = start;
    SchemeResult result;
    double &delta = results.rigid_displacement;
    const auto solve = [&] {
      const unsigned int steps_before = result.steps; // several solutions: one count for all
      const auto count_on = [&](StepRecord record) {
        record.step += steps_before;
        observer(record);
      };
      result = solver_->solve(problem.loads(delta), from, count_on, tolerance);
      result.steps += steps_before;
      if (result.converged())
        from = result.traction;
    };
    const std::size_t index = scene_.body_index(pressed.name());
    const auto force = [&](const double displacement) {
      delta = displacement;
      solve();
      if (!result.converged())
        throw ComputationError(result.message);
      const Eigen::VectorXd contact = problem.contact_forces(index, result.traction);
      return pressed.rigid_side_force(pressed.deformation(contact, delta), contact);
    };
    double guess = std::abs(delta); // of the mesh before
    if (guess == 0.)
    {
      guess = std::abs(pressed.resultant()->force) / pressed.material().young_modulus;
      for (const ContactPair *pair : pairs())
        if (pair->coverage() > 0.)
          guess += std::max(1e-6 * pair->slave().depth, pair->smallest_gap());
    }
    delta =
        find_rigid_displacement(force, pressed.resultant()->force, guess, std::max(10. * tolerance, 1e-10),
                                "Body " + pressed.name() + ", side " + pressed.resultant()->boundary);
    return result;
  }

  bool Simulation::adapts() const
  {
    return std::any_of(scene_.bodies.begin(), scene_.bodies.end(),
                       [](const BodyDescription &body) { return body.adapt; });
  }

  std::optional<CarriedState> Simulation::adapt(const CarriedState &state, Results &results)
  {
    const Stopwatch watch(results.times.adapt);
    const auto n_meshes = [&] {
      unsigned int sum = 0;
      for (const auto &body : bodies())
        sum += body->mesh_version();
      return sum;
    };
    const unsigned int before = n_meshes();
    const CarriedState carried =
        model_->adapt(mark_all(scene_, estimation_, results.bodies, results.pairs), state);
    if (n_meshes() > before || scene_.adaptation.combined)
      return carried;
    results.adaptation_end = {"no cell to split",
                              limit_message(results, "no cell is left that could be split")};
    return {};
  }
} // namespace abut
