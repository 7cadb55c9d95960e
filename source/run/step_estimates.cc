// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/contact_mismatch.h>
#include <abut/run/step_estimates.h>

#include <cmath>

namespace abut
{
  std::vector<BodyResult> StepEstimates::bodies_at(const StepRecord &record) const
  {
    const InterfaceProblem &problem = setup_.model.problem();
    const auto &bodies = setup_.model.bodies();
    std::vector<BodyResult> results =
        setup_.model.executor().of_bodies(bodies.size(), [&](const std::size_t a) {
          BodyResult result;
          result.contact_forces = problem.contact_forces(a, *record.answered);
          result.deformation = bodies[a]->deformation(result.contact_forces, 0.);
          result.displacement = result.deformation + bodies[a]->rigid_motion(0.);
          result.estimate_forces = problem.contact_forces(a, *record.applied);
          return result;
        });
    for (std::size_t a = 0; a < bodies.size(); ++a)
      results[a].body = bodies[a].get();
    return results;
  }

  std::optional<StepEstimates::Norms> StepEstimates::true_error(const std::vector<BodyResult> &bodies)
  {
    Norms squares{0., 0.};
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      const OwnStress stress = setup_.exact == nullptr ? OwnStress() : setup_.exact->stress(a);
      if (!stress)
        return {};
      const std::vector<StressSample> samples = stress_samples(bodies[a], SamplePoints::comparison);
      if (exact_stresses_.size() == a)
        exact_stresses_.push_back(at_samples(stress, samples));
      const Material material = bodies[a].body->material();
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const Stress &exact = exact_stresses_[a][i];
        squares.error += samples[i].weight * material.energy_density(samples[i].computed - exact);
        squares.exact += samples[i].weight * material.energy_density(exact);
      }
    }
    return Norms{std::sqrt(squares.error), std::sqrt(squares.exact)};
  }

  std::optional<StepEstimate> StepEstimates::at(const StepRecord &record, Stopwatch &solving)
  {
    if (record.answered == nullptr)
      return {};
    Assert(record.applied != nullptr && setup_.indicator != nullptr,
           dealii::ExcMessage("an estimate needs pressures and an indicator"));
    std::vector<BodyResult> bodies;
    Estimation estimation;
    {
      const Stopwatch watch(times_.estimate, solving);
      bodies = bodies_at(record);
      estimation = estimate(*setup_.indicator, setup_.scene.adaptation, bodies, setup_.model.executor());
      estimation.mismatch = contact_mismatch(setup_.model.problem(), *record.applied, bodies);
      boundary_cost_ += estimation.boundary_cost();
    }
    const Stopwatch watch(times_.reference, solving);
    StepEstimate result{estimation.discretisation(), estimation.bound(), {}, {}, {}};
    const auto norms = true_error(bodies);
    if (!norms || !(norms->exact > 0.) || !(norms->error > 0.))
      return result;
    result.true_error = norms->error / norms->exact;
    result.ratio = estimation.energy_error() / norms->error;
    result.bound_ratio = *estimation.energy_bound() / norms->error;
    return result;
  }
} // namespace abut
