// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/outline.h>

namespace abut
{
  /// Throws UserError, beginning with `where`, for an outline that bounds no body: none, an open curve,
  /// curves that meet themselves or each other, holes outside the first curve.
  void check_outline(const std::vector<OutlineLoop> &loops, const std::string &where);

  /// Points along a piece from its start to its end, both included; those of a spline (Catmull-Rom) in chords
  /// between the points given.
  std::vector<Vector2> points_along(const Vector2 &start, const OutlinePiece &piece);
} // namespace abut
