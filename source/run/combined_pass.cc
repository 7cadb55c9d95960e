// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/neumann_step.h>
#include <abut/run/combined_pass.h>

#include <cmath>

namespace abut
{
  namespace
  {
    using Bodies = std::vector<std::unique_ptr<Body>>;
    using Fields = std::vector<Eigen::VectorXd>;

    /// The field whose contact nodes move as a response says, along their normals, and no others.
    Eigen::VectorXd field_on_contact_nodes(const Body &body, const Eigen::VectorXd &normal_displacements)
    {
      Eigen::VectorXd trace(body.trace_size());
      Eigen::Index node = 0;
      for (const Trace &side : body.contact_sides())
        for (const Vector2 &normal : side.node_normals())
        {
          trace.segment<2>(2 * node) = normal_displacements[node] * normal;
          ++node;
        }
      return body.extended_by_zero(trace);
    }

    /// ||u - v||_A
    double energy_distance(const Model &model, const Fields &u, const Fields &v)
    {
      double square = 0.;
      for (const double energy : model.executor().of_bodies(
               u.size(), [&](const std::size_t a) { return model.bodies()[a]->strain_energy(u[a] - v[a]); }))
        square += 2. * energy;
      return std::sqrt(square);
    }

    /// A bound in terms of a norm; infinite before anything presses.
    double relative(const double bound, const double norm)
    {
      return bound == 0. ? 0. : bound / norm;
    }
  } // namespace

  CarriedState CombinedPass::initial_state(const InterfaceProblem::Loads &loads)
  {
    const InterfaceProblem &problem = setup_.model.problem();
    const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
    const InterfaceState guess =
        initial_guess(problem, *compliance, loads, setup_.scene.decomposition.initial_guess);
    state_is_field_ = guess.traction.has_value();
    if (guess.traction)
      return {setup_.model.respond(*guess.traction), *guess.traction};
    Fields displacements =
        setup_.model.executor().of_bodies(problem.bodies().size(), [&](const std::size_t a) {
          return field_on_contact_nodes(*setup_.model.bodies()[a],
                                        problem.normal_displacements(guess.response, a));
        });
    return {std::move(displacements), Eigen::VectorXd::Zero(problem.n_pressures())};
  }

  void CombinedPass::take_step(const CarriedState &state, const InterfaceProblem::Loads &loads,
                               const RunObserver &observer, PassOutcome &outcome) const
  {
    const InterfaceProblem &problem = setup_.model.problem();
    AssertDimension(state.displacements.size(), problem.bodies().size());
    AssertDimension(state.pressures.size(), problem.n_pressures());
    const double gamma = choose_relaxation(problem, setup_.scene.decomposition);
    const Eigen::VectorXd response = setup_.model.observe(state.displacements);
    NeumannStep<Fields> step =
        take_neumann_step(problem, gamma, state.displacements, response,
                          [&](const Eigen::VectorXd &pressures) { return setup_.model.respond(pressures); });
    outcome.state.pressures = relaxed(gamma, step.pressures, problem.law().project(state.pressures));

    SchemeResult &iteration = outcome.solution.iteration;
    iteration.traction = state_is_field_ ? outcome.state.pressures : step.pressures;
    iteration.iterate = setup_.model.observe(step.next);
    iteration.response = setup_.model.observe(setup_.model.respond(iteration.traction));
    iteration.steps = 1;
    iteration.relaxation = gamma;
    iteration.increment = relative_change(problem, iteration.iterate, response);
    iteration.stopped_by = setup_.scene.decomposition.stopping_rule == StoppingRule::bound
                               ? StoppedBy::bound
                               : StoppedBy::increment;
    if (state_is_field_)
      iteration.iteration_error = relative(energy_distance(setup_.model, step.solved, state.displacements),
                                           reference_norm(problem, loads, state.pressures, response));
    outcome.state.displacements = std::move(step.next);
    if (observer.step)
      observer.step(step_record(problem, 1, iteration.increment, iteration.iteration_error, step.pressures));
  }

  PassOutcome CombinedPass::run(const std::optional<CarriedState> &carried, const RunObserver &observer)
  {
    PassOutcome outcome;
    {
      const Stopwatch watch(outcome.times.interface);
      const InterfaceProblem::Loads loads = setup_.model.problem().loads(0.);
      take_step(carried ? *carried : initial_state(loads), loads, observer, outcome);
    }
    evaluate(outcome, nullptr);
    return outcome;
  }
} // namespace abut
