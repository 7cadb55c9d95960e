// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <vector>

namespace abut
{
  using Polyline = std::vector<Vector2>;

  /// The nodes of a side with the displacements of its body.
  Polyline deformed_nodes(const Trace &side, const Eigen::VectorXd &displacement);

  /**
   * For every body the vector by which it is to be drawn elsewhere: zero unless a pair overlaps, with the
   * displacements of all bodies as they are `drawn`, by more than a hundredth of the scene's size. Then one
   * of the two is moved along the mean normal of the slave side until the smallest distance in that direction
   * is two hundredths. Left where they are: sides that run all around, and pairs that close a ring of bodies.
   */
  Polyline shifts_apart(const Results &results, const std::vector<Eigen::VectorXd> &drawn, double scene_size);
} // namespace abut
