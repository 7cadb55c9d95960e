// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>
#include <abut/run/step_estimates.h>

#include <cmath>

namespace abut
{
  StepEstimates::StepEstimates(const Scene &scene, const Model &model, const Indicator *indicator,
                               const ExactSolution *exact)
      : scene_(scene), model_(model), indicator_(indicator), exact_(exact)
  {}

  std::vector<BodyResult> StepEstimates::bodies_at(const StepRecord &record) const
  {
    const InterfaceProblem &problem = model_.problem();
    std::vector<BodyResult> results(model_.bodies().size());
    for_each_body(results.size(), [&](const std::size_t a) {
      const Body &body = *model_.bodies()[a];
      results[a].body = &body;
      results[a].deformation = body.deformation(problem.contact_forces(a, *record.answered), 0.);
      results[a].displacement = results[a].deformation + body.rigid_motion(0.);
      results[a].contact_forces = problem.contact_forces(a, *record.applied);
    });
    return results;
  }

  std::optional<StepEstimates::Norms> StepEstimates::true_error(const std::vector<BodyResult> &bodies)
  {
    Norms squares{0., 0.};
    for (std::size_t a = 0; a < bodies.size(); ++a)
    {
      const OwnStress stress = exact_ == nullptr ? OwnStress() : exact_->stress(a);
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

  std::optional<StepEstimate> StepEstimates::at(const StepRecord &record)
  {
    if (record.answered == nullptr)
      return {};
    std::vector<BodyResult> bodies;
    Estimation estimation;
    {
      const Stopwatch watch(estimate_seconds_);
      bodies = bodies_at(record);
      estimation = estimate(*indicator_, scene_.adaptation, bodies);
      estimation.mismatch = contact_mismatch(model_.problem(), *record.applied, bodies);
      boundary_cost_ += estimation.boundary_cost();
    }
    const Stopwatch watch(reference_seconds_);
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
