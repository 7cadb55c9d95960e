// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/common_normal.h>

#include <cstddef>
#include <vector>

namespace abut
{
  /// A side of a body where it meets others.
  struct SurfaceSide
  {
    const Trace *trace;
    double plane_modulus; ///< E / (1 - nu^2)
    std::size_t body;     ///< position in the scene
    std::size_t side;     ///< among the body's contact sides
  };

  /// Which side's segments the multipliers of a pair follow.
  enum class Carrier
  {
    automatic, ///< piece by piece, see Partition
    cut,
    other
  };

  /// Two sides that may touch.
  struct SurfaceLink
  {
    std::size_t cut, other; ///< positions in Surface
    double deepest;         ///< overlap beyond which a point was found right through a body
    Carrier carrier;
  };

  /**
   * Sides that meet as one surface: `cut`, a row of sides that is cut into parts, and the `others` that they
   * may touch. The traces must outlive the object.
   */
  struct Surface
  {
    std::vector<SurfaceSide> cut, others;
    std::vector<SurfaceLink> links;
  };

  /// An interval of a segment of a cut side that lies opposite one segment of another side.
  struct Piece
  {
    std::size_t link;
    std::size_t cut_segment, other_segment;
    double start, end;    ///< in the cut segment's s
    double arc = 0.;      ///< place of its start along the surface (see Partition)
    std::size_t part = 0; ///< the part that it belongs to
  };

  /**
   * Cuts the segments of the cut sides where the ends of the others' segments lie opposite, and pairs each
   * piece with the first segment that it meets and that faces it. What nothing faces is left out. `normals`:
   * one for each link.
   */
  std::vector<Piece> common_refinement(const Surface &surface, const std::vector<CommonNormal> &normals);

  /// The pairing of every link.
  std::vector<CommonNormal> common_normals(const Surface &surface);

  /// Length of an interval of a segment.
  double arc_length(const Trace &side, const Segment &segment, double start, double end);
} // namespace abut
