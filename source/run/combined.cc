// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The combined algorithm of the paper, its Fig. 2: one step of the decomposition and one of the adaptation a
// pass.

#include <abut/base/stopwatch.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/neumann_step.h>
#include <abut/decomposition/spectrum.h>
#include <abut/run/simulation.h>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// The displacements of all bodies on their contact sides.
    std::vector<Eigen::VectorXd> traces(const std::vector<std::unique_ptr<Body>> &bodies,
                                        const std::vector<Eigen::VectorXd> &displacements)
    {
      std::vector<Eigen::VectorXd> result;
      for (std::size_t a = 0; a < bodies.size(); ++a)
        result.push_back(bodies[a]->trace_of(displacements[a]));
      return result;
    }

    /// The responses of the bodies to pressures of all pairs.
    std::vector<Eigen::VectorXd> respond(const std::vector<std::unique_ptr<Body>> &bodies,
                                         const InterfaceProblem &problem, const Eigen::VectorXd &pressures)
    {
      std::vector<Eigen::VectorXd> displacements(bodies.size());
      for_each_body(bodies.size(), [&](const std::size_t a) {
        displacements[a] = bodies[a]->displacement(problem.contact_forces(a, pressures), 0.);
      });
      return displacements;
    }

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
    double energy_distance(const std::vector<std::unique_ptr<Body>> &bodies,
                           const std::vector<Eigen::VectorXd> &u, const std::vector<Eigen::VectorXd> &v)
    {
      double square = 0.;
      for (std::size_t a = 0; a < bodies.size(); ++a)
        square += 2. * bodies[a]->strain_energy(u[a] - v[a]);
      return std::sqrt(square);
    }

    /// A bound in terms of a norm; infinite before anything presses.
    double relative(const double bound, const double norm)
    {
      return bound == 0. ? 0. : bound / norm;
    }
  } // namespace

  std::string Simulation::combined_accident(const Results &results) const
  {
    const auto compliance = make_compliance(model_->problem(), ComplianceMode::solves, 0.);
    return accident_message(model_->problem(), *compliance, results.iteration.relaxation,
                            results.iteration.traction);
  }

  std::string Simulation::relaxation_hint() const
  {
    if (!scene_.decomposition.relaxation)
      return {};
    const auto compliance = make_compliance(model_->problem(), ComplianceMode::solves, 0.);
    const double limit = 2. / largest_eigenvalue(model_->problem(), *compliance);
    if (*scene_.decomposition.relaxation < limit)
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "; but gamma = " << *scene_.decomposition.relaxation << " is not below gamma* = " << limit
         << ", so that the steps need not converge: set Decomposition/Relaxation to automatic or to a "
            "smaller number";
    return text.str();
  }

  CarriedState Simulation::initial_state(const InterfaceProblem::Loads &loads)
  {
    const InterfaceProblem &problem = model_->problem();
    const auto compliance = make_compliance(problem, ComplianceMode::solves, 0.);
    const InterfaceState guess =
        initial_guess(problem, *compliance, loads, scene_.decomposition.initial_guess);
    state_is_field_ = guess.traction.has_value();
    if (guess.traction)
      return {respond(bodies(), problem, *guess.traction), *guess.traction};
    CarriedState state{{}, Eigen::VectorXd::Zero(problem.n_pressures())};
    for (std::size_t a = 0; a < bodies().size(); ++a)
      state.displacements.push_back(
          field_on_contact_nodes(*bodies()[a], problem.normal_displacements(guess.response, a)));
    return state;
  }

  CarriedState Simulation::take_combined_step(const std::optional<CarriedState> &carried,
                                              const RunObserver &observer, Results &results)
  {
    const InterfaceProblem &problem = model_->problem();
    CarriedState next;
    {
      const Stopwatch watch(results.times.interface);
      const InterfaceProblem::Loads loads = problem.loads(0.);
      const CarriedState state = carried ? *carried : initial_state(loads); // u^k
      const double gamma = choose_relaxation(problem, scene_.decomposition);

      const Eigen::VectorXd response = problem.observe(traces(bodies(), state.displacements));
      const auto answer = [&](const Eigen::VectorXd &p) { return respond(bodies(), problem, p); };
      auto [pressures, solved, moved] =
          take_neumann_step(problem, gamma, state.displacements, response, answer);
      next.displacements = std::move(moved);
      next.pressures = relaxed(gamma, pressures, state.pressures.cwiseMax(0.));

      SchemeResult &iteration = results.iteration;
      iteration.traction = state_is_field_ ? next.pressures : pressures;
      iteration.iterate = problem.observe(traces(bodies(), next.displacements));
      iteration.response = problem.observe(traces(bodies(), respond(bodies(), problem, iteration.traction)));
      iteration.steps = 1;
      iteration.relaxation = gamma;
      iteration.increment = relative_change(problem, iteration.iterate, response);
      iteration.stopped_by =
          scene_.decomposition.stopping_rule == StoppingRule::bound ? StoppedBy::bound : StoppedBy::increment;
      const double norm = reference_norm(problem, loads, state.pressures, response);
      if (state_is_field_)
        iteration.iteration_error = relative(energy_distance(bodies(), solved, state.displacements), norm);
      if (observer.step)
        observer.step(step_record(problem, 1, iteration.increment, iteration.iteration_error, pressures));
    }
    evaluate(results);
    return next;
  }
} // namespace abut
