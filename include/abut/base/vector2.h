// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /// A point or a vector of the plane.
  using Vector2 = Eigen::Vector2d;
} // namespace abut
