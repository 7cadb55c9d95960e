// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <limits>
#include <vector>

namespace abut
{
  /// A stretch of a cut side under pressure: from each place a line along the normal, as long as the pressure
  /// there.
  struct Comb
  {
    Polyline base, tips;
  };

  /// Of all contacts; the largest pressure is a tenth of the scene's size.
  std::vector<Comb> combs_of(const DrawnScene &scene);

  /// What is drawn lies within.
  struct Box
  {
    Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
    Vector2 high = -low;

    void include(const Polyline &points);
    Vector2 size() const { return high - low; }
  };

  Box box_around(const DrawnScene &scene, const std::vector<Comb> &combs);
} // namespace abut
