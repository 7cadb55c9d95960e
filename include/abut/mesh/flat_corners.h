// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

#include <optional>

namespace abut
{
  // A cell that has two edges on one smooth piece of the boundary has an angle of 180 degrees between them:
  // its chart is singular there, and refinement makes it worse.

  /// The vertex of such an angle (within 10 degrees), if there is one.
  std::optional<Vector2> flat_corner(const RawMesh &mesh);

  /// Takes the edge opposite such an angle of a triangle to the vertex of the angle, where the neighbour is
  /// of the same material and both new triangles are sound.
  void swap_flat_corners(RawMesh &mesh);
} // namespace abut
