// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a pass tells: results, estimates, true errors, and whether it is the last one.

#include <abut/base/stopwatch.h>
#include <abut/comparison/quality.h>
#include <abut/comparison/true_errors.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/run/bound_conditions.h>
#include <abut/run/simulation.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Pressures that the contact law makes of the displacement; without a penalty any that push satisfy it
    /// as far as they meet no gap.
    Eigen::VectorXd pressures_by_law(const InterfaceProblem &problem, const SchemeResult &iteration)
    {
      if (iteration.motions.size() >
          0) // only these balance what floats; the estimate holds for all that push
        return iteration.traction;
      return (problem.penalties().array() > 0.)
          .select(problem.pressures(iteration.response), iteration.traction);
    }
  } // namespace

  void Simulation::count_boundary_elements(const BoundaryCost &cost, Results &results)
  {
    cost_.boundary += cost;
    results.times.bem += cost.seconds();
  }

  void Simulation::evaluate(Results &results)
  {
    {
      const Stopwatch watch(results.times.solve);
      results.bodies.resize(bodies().size());
      for_each_body(bodies().size(),
                    [&](const std::size_t a) { results.bodies[a] = body_result(a, results); });
    }
    results.pairs.clear();
    for (std::size_t i = 0; i < pairs().size(); ++i)
      results.pairs.push_back(pair_result(i, results));
    if (!indicator_)
      return;
    const Stopwatch watch(results.times.estimate);
    const bool by_law = scene_.adaptation.estimates_by_law();
    const Eigen::VectorXd law =
        by_law ? pressures_by_law(model_->problem(), results.iteration) : Eigen::VectorXd();
    for (std::size_t a = 0; by_law && a < bodies().size(); ++a)
      results.bodies[a].contact_forces = model_->problem().contact_forces(a, law);
    estimation_ = estimate(*indicator_, scene_.adaptation, results.bodies);
    if (by_law)
      estimation_.mismatch = contact_mismatch(model_->problem(), law, results.bodies);
    for (std::size_t a = 0; a < bodies().size(); ++a)
    {
      results.bodies[a].eta = estimation_.eta[a];
      results.bodies[a].better = estimation_.errors[a].better;
    }
    count_boundary_elements(estimation_.boundary_cost(), results);
    // Sizes are those of one estimate, however many were made.
    cost_.boundary.elements = estimation_.boundary_cost().elements;
    cost_.boundary.unknowns = estimation_.boundary_cost().unknowns;
  }

  namespace
  {
    /// Energy norm of the difference from the fields of the mesh before, by that of the solution.
    std::optional<double> change(const std::vector<BodyResult> &bodies,
                                 const std::vector<Eigen::VectorXd> &before)
    {
      double difference = 0., energy = 0.;
      for (std::size_t a = 0; a < bodies.size(); ++a)
      {
        difference += bodies[a].body->strain_energy(bodies[a].displacement - before[a]);
        energy += bodies[a].energy;
      }
      return energy > 0. ? std::sqrt(difference / energy) : 0.;
    }

    std::optional<double> ratio(const std::optional<double> &estimated, const std::optional<double> &exact)
    {
      if (!estimated || !exact || !(*exact > 0.))
        return {};
      return *estimated / *exact;
    }
  } // namespace

  PassRecord Simulation::record_pass(const std::optional<CarriedState> &carried, Results &results) const
  {
    PassRecord record;
    record.pass = static_cast<unsigned int>(results.passes.size());
    record.counts = counts();
    for (const auto &body : bodies())
      record.meshes.push_back(body->mesh_quality());
    record.cost = cost_;
    record.steps = results.iteration.steps;
    record.increment = results.iteration.increment;
    record.iteration = results.iteration.iteration_error;
    for (const PairResult &pair : results.pairs)
    {
      record.normal_force += pair.normal_force;
      record.max_pressure = std::max(record.max_pressure, pair.max_pressure);
      record.n_missed += pair.missed.size();
    }
    if (carried)
      record.change = change(results.bodies, carried->displacements);
    if (indicator_)
    {
      record.eta_max = estimation_.eta_max(scene_);
      record.discretisation = estimation_.discretisation();
      record.stress = estimation_.stress();
      if (const auto bound = estimation_.bound())
        record.total = bound;
      else if (std::isfinite(record.iteration))
        record.total = std::hypot(*record.discretisation, record.iteration);
      record.estimate_reason = why_no_bound(scene_, results);
    }
    if (exact_)
    {
      const Stopwatch watch(results.times.reference);
      record.true_errors = results.true_errors = true_errors(*exact_, scene_, results.bodies, results.pairs);
      if (indicator_)
        record.quality = estimator_quality(*exact_, estimation_, results.bodies, results.pairs);
      record.effectivity_total = ratio(record.total, record.true_errors.energy);
    }
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() -
                     results.times.reference;
    return record;
  }

  std::string Simulation::limit_message(const Results &results, const std::string &cause) const
  {
    const AdaptationParameters &adaptation = scene_.adaptation;
    const PassRecord &pass = results.passes.back();
    if (adaptation.limit == 0. ||
        (*pass.eta_max <= adaptation.limit && !adaptation.combined && pass.n_missed == 0))
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "The adaptation has not reached its goal: " << cause << ", eta is " << *pass.eta_max
         << " where Adaptation/Limit = " << adaptation.limit;
    if (adaptation.combined)
      text << ", the last increment of the contact displacement " << pass.increment
           << " where Decomposition/Tolerance = " << scene_.decomposition.tolerance;
    if (pass.n_missed > 0)
      text << ", contact smaller than a cell is left";
    text << ". Raise Adaptation/Maximum passes (or Maximum unknowns) or the limit";
    if (adaptation.combined)
      text << relaxation_hint();
    return text.str();
  }

  bool Simulation::is_last_pass(Results &results) const
  {
    const AdaptationParameters &adaptation = scene_.adaptation;
    if (!results.iteration.converged() || !adapts())
      return true;
    const PassRecord &pass = results.passes.back();
    const bool by_bound = scene_.decomposition.stopping_rule == StoppingRule::bound;
    const bool steady = !adaptation.combined ||
                        (by_bound ? pass.iteration : pass.increment) <= scene_.decomposition.tolerance;
    if (adaptation.limit > 0. && *pass.eta_max <= adaptation.limit && steady && pass.n_missed == 0)
      results.adaptation_end = {"limit", adaptation.combined && !by_bound ? combined_accident(results) : ""};
    else if (results.passes.size() >= adaptation.maximum_passes)
      results.adaptation_end = {"maximum passes", limit_message(results, "the maximum of passes has come")};
    else if (pass.counts.dofs >= adaptation.maximum_unknowns)
      results.adaptation_end = {"maximum unknowns",
                                limit_message(results, "the maximum of unknowns has come")};
    return results.adaptation_end.has_value();
  }
} // namespace abut
