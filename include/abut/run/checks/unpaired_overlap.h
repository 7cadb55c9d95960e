// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/model.h>

#include <optional>

namespace abut
{
  /// Where a side of one body lies within another body and no pair joins the sides.
  struct UnpairedOverlap
  {
    std::array<std::size_t, 2> bodies; ///< in the scene's order
    std::array<std::string, 2> sides;  ///< of either
    Vector2 place;                     ///< as displaced
    double depth;                      ///< from there to the other body's side
  };

  /**
   * The deepest of every two bodies. `displacements`: of all bodies, all unknowns; empty: none. What counts
   * is more than curves that should touch may miss each other by, and more than what the squares of rotations
   * change. Next to the end of a pair's side nothing counts that is no farther from it than twice the depth:
   * corners that press in. Rigid bodies that cannot move may overlap each other.
   */
  std::vector<UnpairedOverlap> unpaired_overlaps(const Scene &scene, const Model &model,
                                                 const std::vector<Eigen::VectorXd> &displacements);
} // namespace abut
