// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/surface.h>

namespace abut
{
  /// A piece of a surface between bounds of boxes, with what its surroundings are.
  struct Atom
  {
    Piece piece;
    bool other_carries; ///< the multipliers follow the other side's segments, not the cut one's
    double length;
    double end_arc;                             ///< place of its end along the surface
    bool cut_before = false, cut_after = false; ///< a box ends there
    bool joined = false; ///< to the next atom, for the last of a closed row to its first
  };

  /// The common refinement, cut at the bounds of the carriers' boxes, in the order of the surface (see
  /// SurfaceLine). A closed row begins at the start of a stretch or, where it is covered all round, of a box.
  std::vector<Atom> cut_into_atoms(const Surface &surface, const std::vector<CommonNormal> &normals);
} // namespace abut
