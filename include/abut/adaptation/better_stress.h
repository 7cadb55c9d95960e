// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /// Takes the difference between a better stress, at SamplePoints::comparison, and the body's own for the
  /// error of the latter. Sets all fields of CellErrors but those that only fe-be has. `better` has an entry
  /// for every point of all cells, in the order of Body::visit_stress.
  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better);

  /// The same in the cells at singular vertices, where Gauss points miss some per cent of the error, with the
  /// better stress at Body::visit_corner_stress's points; in place of what `compare` found there.
  void compare_at_corners(const BodySolution &solution, const std::vector<Stress> &better,
                          CellErrors &errors);
} // namespace abut
