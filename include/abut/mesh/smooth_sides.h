// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

namespace abut
{
  /**
   * Gives the edges of a mesh, whose boundary is known by points alone, the smooth curve through these: cubic
   * pieces whose tangents come from the circle through a point and its two neighbours, so that arcs come out
   * as arcs (to 4/27 (a/4)^6 of the radius, a the angle of an edge), and straight runs of edges stay
   * straight. The curve breaks where the boundary turns by `corner_angle` (radians) or more and where one
   * side or material meets another; there its tangent is that of the circle through the next two points.
   *
   * `between`: further points of the curve between the vertices of an edge, in its order (second-order
   * nodes); empty or one for each edge. Edges have the body on their left.
   */
  void smooth_sides(RawMesh &mesh, const std::vector<std::vector<Vector2>> &between, double corner_angle);
} // namespace abut
