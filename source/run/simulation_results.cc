// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a solved interface means for bodies and pairs.

#include <abut/base/user_error.h>
#include <abut/run/simulation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Distance of the reported state from the limit of the iteration.
    LimitDistance distance_from(const SchemeResult &limit, const SchemeResult &reached,
                                const InterfaceProblem &problem, const double energy_norm)
    {
      LimitDistance distance;
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      {
        const Eigen::VectorXd there = problem.normal_displacements(limit.response, a);
        const double difference = (problem.normal_displacements(reached.iterate, a) - there).norm();
        if (difference > 0.)
          distance.displacement = std::max(distance.displacement, difference / there.norm());
      }
      const Index n = problem.n_pressures();
      const double square =
          (reached.traction - limit.traction).dot((reached.response - limit.response).head(n));
      distance.energy = std::sqrt(std::max(square, 0.)) / energy_norm;
      distance.peak_pressure = n > 0 ? limit.traction.maxCoeff() : 0.;
      return distance;
    }
  } // namespace

  BodyResult Simulation::body_result(const std::size_t index, const Results &results) const
  {
    const Body &body = *bodies()[index];
    const Eigen::VectorXd contact = model_->problem().contact_forces(index, results.iteration.traction);
    BodyResult result;
    result.body = &body;
    result.contact_forces = contact;
    result.rigid_displacement = results.rigid_displacement;
    Eigen::VectorXd motion;
    if (results.iteration.motions.size() > 0)
    {
      const Eigen::VectorXd own = solver_->motions()->all.of_body(results.iteration.motions, index);
      result.rigid_displacement = body.rigid_side_displacement(own);
      motion = body.free_motion(own);
    }
    result.deformation = body.deformation(contact, result.rigid_displacement);
    result.displacement = result.deformation + body.rigid_motion(result.rigid_displacement);
    if (motion.size() > 0)
      result.displacement += motion;
    result.energy = body.strain_energy(result.deformation);
    result.reactions = body.reactions(result.deformation, contact);
    return result;
  }

  void Simulation::find_all_peaks(Results &results)
  {
    for (BodyResult &result : results.bodies)
    {
      result.peaks =
          find_peaks(*result.body, result.displacement, result.deformation, result.body->singular_vertices());
      if (!std::isfinite(result.energy) || !std::isfinite(result.peaks.von_mises.value))
        throw ComputationError(
            "Body " + result.body->name() +
            ": energy or stresses have left the range of the machine's numbers; change the units");
    }
  }

  PairResult Simulation::pair_result(const std::size_t index, const Results &results) const
  {
    const InterfaceProblem &problem = model_->problem();
    const ContactPair &pair = *pairs()[index];
    const std::size_t surface = model_->surface_of(index);
    PairResult result;
    result.pair = &pair;
    result.surface = &model_->surfaces()[surface];
    result.gaps = problem.of_surface(surface, problem.gaps(results.iteration.response));
    result.loads = problem.of_surface(surface, results.iteration.traction);
    result.round_off = 1e-12 * results.iteration.traction.cwiseAbs().maxCoeff();
    result.pressures = result.surface->partition().reported_pressures(result.loads);
    const Eigen::VectorXd forces = pair.slave_coupling().transpose() * result.loads;
    for (Index i = 0; i < forces.size(); i += 2)
      result.force += forces.segment<2>(i);
    result.normal_force = pair.weights().dot(result.loads);
    result.min_gap = std::numeric_limits<double>::infinity();
    std::vector<bool> pressed(static_cast<std::size_t>(result.loads.size()));
    for (std::size_t k = 0; k < pressed.size(); ++k)
    {
      const auto i = static_cast<Index>(k);
      pressed[k] = result.loads[i] > 0. || (pair.penalty() > 0. && result.gaps[i] < 0.);
      if (!(pair.weights()[i] > 0.))
        continue;
      result.parts.push_back(k);
      result.max_pressure = std::max(result.max_pressure, result.pressures[i]);
      result.contact_length += pressed[k] ? pair.weights()[i] : 0.;
      result.min_gap = std::min(result.min_gap, result.gaps[i]);
    }
    result.max_penetration = std::max(0., -result.min_gap);
    const auto displacement = [&](const ContactBody &side) -> Eigen::VectorXd {
      const BodyResult &body = results.bodies[side.body];
      return body.body->trace_of(body.displacement)
          .segment(body.body->trace_offset(side.side), static_cast<Index>(2 * side.trace->n_nodes()));
    };
    const Eigen::VectorXd of_cut = displacement(pair.cut_side()), of_other = displacement(pair.other_side());
    result.missed = pair.missed_contact(result.surface->near_contact(pressed), of_cut, of_other);
    result.nearest = pair.nearest(of_cut, of_other);
    result.sliding = pair.sliding(of_cut, of_other);
    for (const std::size_t k : result.parts)
      if (result.presses(k))
        result.max_sliding = std::max(result.max_sliding, std::abs(result.sliding[static_cast<Index>(k)]));
    return result;
  }

  std::optional<LimitDistance> Simulation::limit_distance(const Results &results) const
  {
    const SchemeResult &reached = results.iteration;
    if (!solver_ || reached.stopped_by != StoppedBy::increment || !reached.converged() ||
        !results.compliance_is_dense)
      return {};
    const InterfaceProblem &problem = model_->problem();
    const SchemeResult limit = solver_->limit(problem.loads(results.rigid_displacement), reached.traction);
    if (!limit.converged())
      return {};
    double energy = 0.;
    for (const BodyResult &body : results.bodies)
      energy += 2. * body.energy;
    return distance_from(limit, reached, problem, std::sqrt(energy));
  }

  namespace
  {
    /// Which body's error the estimator fe-be sees a part of only; empty where it sees it whole.
    std::string underestimated_body(const Scene &scene, const std::vector<std::unique_ptr<Body>> &bodies)
    {
      if (!Registry<EstimatorEntry>::get().find(scene.adaptation.estimator).has_boundary_elements ||
          scene.adaptation.boundary_solution == BoundarySolution::trace_space ||
          scene.adaptation.boundary_solution == BoundarySolution::reference_quality)
        return {};
      for (const auto &body : bodies)
        if (!body->singular_vertices().empty())
          return body->name();
      return {};
    }
  } // namespace

  Warnings Simulation::scheme_warnings() const
  {
    Warnings warnings;
    if (solver_ && solver_->motions() != nullptr)
      for (const std::string &sentence : solver_->motions()->dropped_loads)
        warnings.push_back({WarningCode::dropped_load, sentence});
    const DecompositionParameters &decomposition = scene_.decomposition;
    if (!scheme_of(decomposition).iterates_displacements && !scene_.contacts.empty() &&
        (decomposition.relaxation || decomposition.initial_guess != DecompositionParameters().initial_guess))
      warnings.push_back({WarningCode::unused_parameter,
                          "Decomposition/Relaxation and Initial guess are for Scheme = neumann; the scheme " +
                              decomposition.scheme + " takes no notice of them"});
    return warnings;
  }

  namespace
  {
    /// That an estimator is far from the true error with some body's degree; empty where it is not.
    std::string rough_estimator(const EstimatorEntry &estimator,
                                const std::vector<std::unique_ptr<Body>> &bodies)
    {
      for (const auto &body : bodies)
      {
        const unsigned int degree = body->description().degree;
        const EstimatorWorth *const worth = estimator.worth_at(degree);
        if (worth == nullptr || !worth->is_rough())
          continue;
        std::ostringstream text;
        text << "Adaptation/Estimator = " << estimator.name << " has been " << worth->least << " to "
             << worth->most << " times the true error with elements of degree " << degree << " (body "
             << body->name()
             << "): its marks are good, its values and a Limit are not; fe-be has a bound, kelly is nearer";
        return text.str();
      }
      return "";
    }
  } // namespace

  Warnings Simulation::estimator_warnings() const
  {
    Warnings warnings;
    if (const std::string sentence =
            rough_estimator(Registry<EstimatorEntry>::get().find(scene_.adaptation.estimator), bodies());
        !sentence.empty())
      warnings.push_back({WarningCode::rough_estimator, sentence});
    const std::string body = underestimated_body(scene_, bodies());
    if (!body.empty())
      warnings.push_back(
          {WarningCode::estimator_sees_a_part,
           "Body " + body +
               " has a vertex where the stress is infinite (a reentrant corner, a support that begins or "
               "ends, a load that jumps): there the boundary elements of Adaptation/Boundary solution = "
               "constant traction and finite element trace are about as coarse as the finite elements, the "
               "error may be a third larger than estimated; trace space and reference quality see it whole"});
    return warnings;
  }

  Warnings Simulation::warnings(const Results &results) const
  {
    Warnings all;
    for (const Warnings &some :
         {input_warnings(), result_warnings(results), scheme_warnings(), estimator_warnings()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  std::vector<std::string> Simulation::left_out(const Results &results) const
  {
    std::vector<std::string> items = {"MPI and p4est (serial run)"};
    if (!indicator_)
      items.emplace_back("error estimation (no estimator asked for)");
    if (!adapts())
      items.emplace_back("adaptation (no body adapts)");
    if (!Registry<EstimatorEntry>::get().find(scene_.adaptation.estimator).has_boundary_elements)
      items.emplace_back("boundary elements (Adaptation/Estimator is not " +
                         estimators_with_boundary_elements() + ")");
    items.emplace_back("mortar coupling inside bodies (hanging nodes)");
    if (scene_.contacts.empty())
      items.emplace_back("contact (a scene without pairs)");
    if (results.iteration.motions.size() == 0)
      items.emplace_back("rigid motions as unknowns of the interface problem (no body floats)");
    if (!results.compliance_is_dense)
      items.emplace_back("dense interface compliance (solves are cheaper here)");
    if (!exact_)
      items.emplace_back("true errors (no exact solution named)");
    return items;
  }
} // namespace abut
