// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// Where the solution is told, on the undeformed bodies.
  struct OutputPoint
  {
    std::string body; ///< the only one asked; empty: all that have the point
    Vector2 place;    ///< world frame
  };

  /// Of `(x, y)` with two numbers; nothing of another text.
  std::optional<Vector2> point_of(const std::string &text);

  /// `(x, y); body: (x, y); ...`, lengths in the plane; empty: none. Throws UserError.
  std::vector<OutputPoint> parse_output_points(const std::string &text);
} // namespace abut
