// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/contact/contact_surface.h>

namespace abut
{
  /// The cells that lie opposite each other along a part of a surface, by their lengths there.
  struct PartCell
  {
    double shorter = 0.; ///< of both sides; at least the part itself, where the coarser side carries
    double longer = 0.;
    /// Of the side that carries the multipliers; of degree 3 as much as has two distances between nodes.
    double carrier = 0.;
  };

  /// The outermost piece of a part at its start (end = 0) or end (1).
  const Piece &outermost_piece(const Partition &partition, std::size_t part, std::size_t end);

  /// Whether both sides have a plane of symmetry (a rigid one may have it anywhere) at the start (end = 0) or
  /// the end (1) of a part.
  bool is_at_symmetry(const ContactSurface &surface, std::size_t part, std::size_t end);

  /// Of every part; of several cells along a part the longest.
  std::vector<PartCell> part_cells(const ContactSurface &surface);
} // namespace abut
