// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/quality.h>
#include <abut/comparison/true_errors.h>
#include <abut/run/bound_conditions.h>
#include <abut/run/pass_record.h>
#include <abut/run/pressure_marks.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// Energy norm of the difference from the fields of the mesh before, by that of the solution.
    double change(const Executor &executor, const std::vector<BodyResult> &bodies,
                  const std::vector<Eigen::VectorXd> &before)
    {
      AssertDimension(bodies.size(), before.size());
      const std::vector<double> differences = executor.of_bodies(bodies.size(), [&](const std::size_t a) {
        return bodies[a].body->strain_energy(bodies[a].displacement - before[a]);
      });
      double difference = 0., energy = 0.;
      for (std::size_t a = 0; a < bodies.size(); ++a)
      {
        difference += differences[a];
        energy += bodies[a].energy;
      }
      return energy > 0. ? std::sqrt(difference / energy) : 0.;
    }

    void add_contact(const std::vector<PairResult> &pairs, PassRecord &record)
    {
      for (const PairResult &pair : pairs)
      {
        record.normal_force += pair.normal_force;
        record.max_pressure = std::max(record.max_pressure, pair.max_pressure);
        record.n_missed += pair.missed.size();
      }
    }

    /// The share of the error that no pass makes smaller: of elastic bodies that do not adapt.
    double staying_error(const Scene &scene, const Estimation &estimation)
    {
      double square = 0.;
      for (std::size_t a = 0; a < scene.bodies.size(); ++a)
        if (!scene.bodies[a].adapt)
          square += estimation.errors[a].energy.squaredNorm();
      return square > 0. ? std::sqrt(square) / estimation.energy_norm() : 0.;
    }

    void add_estimate(const Setup &setup, const PassOutcome &outcome, PassRecord &record)
    {
      const Estimation &estimation = outcome.estimation;
      record.eta_max = estimation.eta_max(setup.scene);
      record.discretisation = estimation.discretisation();
      record.stress = estimation.stress();
      record.budget = outcome.budget;
      record.estimator = estimation.estimator;
      record.staying = staying_error(setup.scene, estimation);
      record.is_certified = estimation.mismatch && estimation.why_uncertified.empty();
      record.estimate_reason = why_no_bound(setup.scene, outcome.solution, estimation);
      if (record.is_certified)
        record.total = record.budget.bound();
      else if (std::isfinite(record.iteration))
        record.total = record.budget.estimate();
    }

    std::optional<double> ratio(const std::optional<double> &estimated, const std::optional<double> &exact)
    {
      if (!estimated || !exact || !(*exact > 0.))
        return {};
      return *estimated / *exact;
    }
  } // namespace

  PassRecord record_pass(const Setup &setup, const PassOutcome &outcome,
                         const std::optional<CarriedState> &carried)
  {
    const Solution &solution = outcome.solution;
    AssertDimension(solution.bodies.size(), setup.model.bodies().size());
    AssertDimension(solution.pairs.size(), setup.model.pairs().size());
    PassRecord record;
    record.counts = setup.model.counts();
    for (const auto &body : setup.model.bodies())
      record.meshes.push_back(body->mesh_quality());
    record.cost = {outcome.times.assemble, outcome.times.factorise, outcome.times.solve,
                   outcome.times.estimate, outcome.boundary};
    record.steps = solution.iteration.steps;
    record.increment = solution.iteration.increment;
    record.iteration = solution.iteration.iteration_error;
    if (std::isfinite(record.iteration)) // known without an estimator of the meshes too
      record.budget.iteration = record.iteration;
    for (const BodyResult &body : solution.bodies)
      record.strain_energy += body.energy;
    add_contact(solution.pairs, record);
    record.pressure = relative_pressure_error(solution.pairs);
    if (carried)
      record.change = change(setup.model.executor(), solution.bodies, carried->displacements);
    if (setup.indicator != nullptr)
      add_estimate(setup, outcome, record);
    return record;
  }

  void correct_by_change(const PassRecord &before, PassRecord &record)
  {
    const auto estimated = before.budget.estimate();
    if (record.is_certified || !record.total || !record.change || !estimated || !(*estimated > 0.) ||
        !(record.strain_energy > 0.))
      return;
    const double by_energy =
        std::sqrt(std::abs(record.strain_energy - before.strain_energy) / record.strain_energy);
    *record.total *= std::max(1., std::min(*record.change, by_energy) / *estimated);
  }

  void compare_with_exact(const Setup &setup, const PassOutcome &outcome, PassRecord &record)
  {
    Assert(setup.exact != nullptr, dealii::ExcMessage("there is nothing to compare with"));
    const Solution &solution = outcome.solution;
    record.true_errors =
        true_errors(*setup.exact, setup.scene, solution.bodies, solution.pairs, setup.model.executor());
    if (setup.indicator != nullptr)
      record.quality = estimator_quality(*setup.exact, outcome.estimation, solution.bodies, solution.pairs,
                                         setup.model.executor());
    record.effectivity_total = ratio(record.total, record.true_errors.energy);
  }
} // namespace abut
