// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <vector>

namespace abut
{
  /// A place on a side of an elastic body, and the cell there.
  struct PlaceOnBody
  {
    std::size_t body;
    Vector2 place; ///< world frame, undeformed
    unsigned int cell;
  };

  /// Those at a place along the surface of a pair, on its two sides; none where they do not face each other.
  std::vector<PlaceOnBody> places_on_bodies(const PairResult &pair, double arc,
                                            const std::vector<BodyResult> &bodies);
} // namespace abut
