// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>
#include <abut/comparison/stress_samples.h>
#include <abut/results/results.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace abut
{
  namespace
  {
    /// Appends what is visited.
    StressVisitor collector(const BodyResult &result, std::vector<StressSample> &samples)
    {
      const Placement &placement = result.body->description().placement;
      return [&](const SamplePoint &point, const Stress &stress) {
        samples.push_back(
            {point.cell, placement.point_to_own(point.place), point.weight, in_own_frame(stress, placement)});
      };
    }
  } // namespace

  std::vector<StressSample> stress_samples(const BodyResult &result, const SamplePoints points)
  {
    AssertDimension(static_cast<std::size_t>(result.deformation.size()), result.body->counts().dofs);
    std::vector<StressSample> samples;
    result.body->visit_stress(result.deformation, points, collector(result, samples));
    return samples;
  }

  std::vector<StressSample> corner_samples(const BodyResult &result)
  {
    std::vector<StressSample> samples;
    result.body->visit_corner_stress(result.deformation, collector(result, samples));
    return samples;
  }

  std::vector<StressSample> precise_samples(const BodyResult &result)
  {
    std::vector<StressSample> samples = stress_samples(result, SamplePoints::precise);
    const std::vector<StressSample> corners = corner_samples(result);
    std::set<unsigned int> cells;
    for (const StressSample &sample : corners)
      cells.insert(sample.cell);
    samples.erase(std::remove_if(samples.begin(), samples.end(),
                                 [&](const StressSample &sample) { return cells.count(sample.cell) > 0; }),
                  samples.end());
    samples.insert(samples.end(), corners.begin(), corners.end());
    return samples;
  }

  Stress in_own_frame(const Stress &s, const Placement &placement)
  {
    Eigen::Matrix2d axes, tensor;
    axes << placement.direction_to_world(Vector2::UnitX()), placement.direction_to_world(Vector2::UnitY());
    tensor << s.xx, s.xy, s.xy, s.yy;
    const Eigen::Matrix2d own = axes.transpose() * tensor * axes;
    return {own(0, 0), own(1, 1), own(0, 1), s.zz};
  }

  std::vector<Stress> at_samples(const OwnStress &exact, const std::vector<StressSample> &samples)
  {
    Assert(exact, dealii::ExcMessage("there is no exact stress to sample"));
    std::vector<Stress> stresses(samples.size());
    for_each(samples.size(), [&](const std::size_t i) { stresses[i] = exact(samples[i].own_point); });
    Assert(std::all_of(stresses.begin(), stresses.end(),
                       [](const Stress &stress) { return std::isfinite(stress.square()); }),
           dealii::ExcMessage("an exact stress inside a body is finite"));
    return stresses;
  }
} // namespace abut
