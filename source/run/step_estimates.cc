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

  StepEstimates::Norms StepEstimates::squares(const BodyResult &body, const OwnStress &stress,
                                              std::vector<Stress> &exact_stresses)
  {
    Norms squares;
    const std::vector<StressSample> samples = stress_samples(body, SamplePoints::comparison);
    if (exact_stresses.empty())
      exact_stresses = at_samples(stress, samples);
    const Material material = body.body->material();
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const Stress &exact = exact_stresses[i];
      squares.error += samples[i].weight * material.energy_density(samples[i].computed - exact);
      squares.exact += samples[i].weight * material.energy_density(exact);
    }
    return squares;
  }

  std::optional<StepEstimates::Norms> StepEstimates::true_error(const std::vector<BodyResult> &bodies)
  {
    std::vector<OwnStress> stresses;
    for (std::size_t a = 0; a < bodies.size(); ++a)
      if (setup_.exact == nullptr || !stresses.emplace_back(setup_.exact->stress(a)))
        return {};
    exact_stresses_.resize(bodies.size());
    Norms sum;
    for (const Norms &of_body : setup_.model.executor().of_bodies(bodies.size(), [&](const std::size_t a) {
           return squares(bodies[a], stresses[a], exact_stresses_[a]);
         }))
    {
      sum.error += of_body.error;
      sum.exact += of_body.exact;
    }
    return Norms{std::sqrt(sum.error), std::sqrt(sum.exact)};
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
