// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <deal.II/grid/tria.h>

namespace abut
{
  // What discs and rings share; their centre is the origin of the own frame.

  /**
   * Direction of the k-th of n + 1 points on the quarter of the unit circle from (1, 0) to (0, 1). Exactly
   * symmetric to the diagonal, exactly zero on the axes.
   */
  Vector2 quarter_circle(unsigned int k, unsigned int n);

  /// Gives the side `outer`, the first of a disc or of a part of it, the circle around the placed centre.
  void attach_outer_circle(dealii::Triangulation<2> &triangulation, const BodyDescription &body);

  /// Gives the whole body polar coordinates around its placed centre.
  void attach_polar_coordinates(dealii::Triangulation<2> &triangulation, const BodyDescription &body);
} // namespace abut
