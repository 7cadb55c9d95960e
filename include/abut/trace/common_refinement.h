// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <vector>

namespace abut
{
  /// A part of a slave segment that lies opposite one master segment.
  struct Piece
  {
    std::size_t slave_segment;
    std::size_t master_segment;
    double start, end; ///< in the slave segment's s
  };

  /**
   * Cuts the slave curve where the ends of master segments project onto it. A slave point x is paired with
   * the master point on the line through x along the averaged slave normal, on a segment that faces it,
   * nearest along that line on either side: bodies may overlap. Parts of the slave that nothing faces are
   * left out.
   */
  std::vector<Piece> common_refinement(const Trace &slave, const Trace &master);

  /// The master point opposite a slave point.
  struct Projection
  {
    double t;   ///< place on the master segment
    double gap; ///< (master point - slave point) . normal: positive where the bodies are apart
  };

  /**
   * Intersects the line through `point` along `normal` with a master segment. Newton's method from the chord;
   * the place may lie outside [0, 1] by as much as the geometry continues smoothly.
   */
  Projection project(const Trace &master, const Segment &segment, const Vector2 &point,
                     const Vector2 &normal);
} // namespace abut
