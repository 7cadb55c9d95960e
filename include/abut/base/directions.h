// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <vector>

namespace abut
{
  /// The directions at right angles to those supported: the two axes, one, or none.
  std::vector<Vector2> free_directions(const std::vector<Vector2> &supported);

  /// The part of a vector along the free directions.
  Vector2 free_part(const std::vector<Vector2> &supported, const Vector2 &vector);
} // namespace abut
