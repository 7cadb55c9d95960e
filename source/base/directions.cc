// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>

namespace abut
{
  std::vector<Vector2> free_directions(const std::vector<Vector2> &supported)
  {
    if (supported.empty())
      return {Vector2::UnitX(), Vector2::UnitY()};
    if (supported.size() == 2)
      return {};
    return {Vector2(-supported.front().y(), supported.front().x())};
  }

  Vector2 free_part(const std::vector<Vector2> &supported, const Vector2 &vector)
  {
    Vector2 part = Vector2::Zero();
    for (const Vector2 &direction : free_directions(supported))
      part += vector.dot(direction) * direction;
    return part;
  }
} // namespace abut
