// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/body.h>

namespace abut
{
  /// The solution at a point of an undeformed body (world frame).
  struct PointResult
  {
    const Body *body = nullptr;
    std::size_t number = 0; ///< among the scene's points, from 1
    Vector2 place = Vector2::Zero();
    Vector2 displacement = Vector2::Zero();
    Stress stress;                           ///< mean over the cells that meet there
    std::vector<MaterialStress> by_material; ///< of each of them, where cells of several meet

    /// All but the body.
    void serialize(Archive &archive) { archive(number, place, displacement, stress, by_material); }
  };
} // namespace abut
