// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <vector>

namespace abut
{
  /// A point of a mesh: in which cell, and where in the reference cell.
  struct LocatedPoint
  {
    Cell cell;
    dealii::Point<2> unit;
  };

  /// The own cells that a point (world frame) belongs to, several where they meet, none outside. Round-off
  /// counts as 1e-8 of a cell. Cells of curved bodies count as they are, not as polygons; a point that none
  /// of them reaches, since they do not follow the curve exactly, belongs to those that it is off by a
  /// twentieth of them.
  std::vector<LocatedPoint> locate(const Space &space, const Vector2 &place);
} // namespace abut
