// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <cmath>
#include <vector>

namespace abut
{
  /// a_x b_y - a_y b_x: positive where b lies to the left of a.
  inline double cross(const Vector2 &a, const Vector2 &b)
  {
    return a.x() * b.y() - a.y() * b.x();
  }

  /// The unit normal to the right of a direction: outward where a curve has its body on the left.
  inline Vector2 outward_normal(const Vector2 &tangent)
  {
    return Vector2(tangent.y(), -tangent.x()).normalized();
  }

  /// The smallest rectangle along the axes around points.
  struct Box
  {
    Vector2 low, high;

    Vector2 middle() const { return .5 * (low + high); }
    double diagonal() const { return (high - low).norm(); }
  };

  /// Of at least one point.
  inline Box box_around(const std::vector<Vector2> &points)
  {
    Box box{points.front(), points.front()};
    for (const Vector2 &point : points)
      box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
    return box;
  }

  /// The angle from one direction to another, positive counter-clockwise, radians.
  inline double turning(const Vector2 &from, const Vector2 &to)
  {
    return std::atan2(cross(from, to), from.dot(to));
  }
} // namespace abut
