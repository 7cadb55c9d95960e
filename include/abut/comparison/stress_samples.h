// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/cells.h>
#include <abut/comparison/exact_solution.h>

#include <vector>

namespace abut
{
  /// A point of a body in the body's own frame, with the body's stress there.
  struct StressSample
  {
    unsigned int cell;
    Vector2 own_point;
    double weight; ///< area
    Stress computed;
  };

  /// Cell by cell. The body has been solved: `deformation` is that of all its unknowns.
  std::vector<StressSample> stress_samples(const BodyResult &result, SamplePoints points);

  /// The same at Body::visit_corner_stress's points: none but in the cells at singular vertices.
  std::vector<StressSample> corner_samples(const BodyResult &result);

  /// The samples of all cells but those at singular vertices, then the corner samples there.
  std::vector<StressSample> precise_samples(const BodyResult &result);

  /// A stress of the plane in the own frame of a body.
  Stress in_own_frame(const Stress &stress, const Placement &placement);

  /// An exact stress at the samples, all finite; in parallel.
  std::vector<Stress> at_samples(const OwnStress &exact, const std::vector<StressSample> &samples);
} // namespace abut
