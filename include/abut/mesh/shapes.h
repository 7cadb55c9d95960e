// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

namespace abut
{
  // Meshes of the built-in shapes, in the body's own frame, in quadrilaterals. Cells and sides: see `Shape`
  // and `BodyDescription`. Boundary ids count the sides in the order given there. Each throws UserError when
  // the cells or the sizes do not fit the shape.

  /// Also the rectangle with a curved top: its columns are stretched from the bottom to the top.
  RawMesh rectangle(const BodyDescription &body);

  /**
   * Disc, half disc and quarter disc: in every quarter a square core of n/2 x n/2 cells (n = cells[0] along
   * the arc, even) and around it n x cells[1] cells up to the arc.
   */
  RawMesh disc(const BodyDescription &body);

  /// Three squares around the origin, n[0] x n[1] cells each.
  RawMesh l_shape(const BodyDescription &body);

  /// Ring and quarter ring, uniform in the angle and in the radius.
  RawMesh ring(const BodyDescription &body);

  /**
   * Direction of the k-th of n + 1 points on the quarter of the unit circle from (1, 0) to (0, 1). Exactly
   * symmetric to the diagonal, exactly zero on the axes.
   */
  Vector2 quarter_circle(unsigned int k, unsigned int n);
} // namespace abut
