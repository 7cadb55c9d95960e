// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /// A body's own stress at some points.
  struct OwnStress
  {
    std::vector<SamplePoint> points;
    std::vector<Stress> values;
  };
  /// At SamplePoints::comparison, in the order of Body::visit_stress.
  OwnStress own_stress(const BodySolution &solution);
  /// At Body::visit_corner_stress's points.
  OwnStress own_stress_at_corners(const BodySolution &solution);

  /// Takes the difference between a better stress and the body's own at the points of `own_stress` for the
  /// error of the latter. Sets all fields of CellErrors but those that only fe-be has.
  CellErrors compare(const Body &body, const OwnStress &own, const std::vector<Stress> &better);
  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better);

  /// The same in the cells at singular vertices, where Gauss points miss some per cent of the error, with the
  /// better stress at the points of `own_stress_at_corners`; in place of what `compare` found there.
  void compare_at_corners(const Body &body, const OwnStress &own, const std::vector<Stress> &better,
                          CellErrors &errors);
} // namespace abut
