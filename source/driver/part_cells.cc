// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/driver/part_cells.h>

#include <algorithm>

namespace abut
{
  bool is_at_symmetry(const ContactSurface &surface, const std::size_t part)
  {
    const Part &place = surface.partition().parts()[part];
    const Trace &side = *surface.cut_sides()[place.side];
    const Segment &segment = side.segments()[place.segment];
    return side.is_plane_of_symmetry(segment, 0) || side.is_plane_of_symmetry(segment, 1);
  }

  std::vector<PartCell> part_cells(const ContactSurface &surface)
  {
    std::vector<PartCell> cells;
    for (const Part &part : surface.partition().parts())
      cells.push_back({part.length, part.length});
    for (const ContactPair &pair : surface.pairs())
      for (const Piece &piece : surface.partition().pieces())
        if (piece.link == pair.link())
        {
          const auto [shorter, longer] =
              std::minmax({pair.cut_side().trace->segments()[piece.cut_segment].length,
                           pair.other_side().trace->segments()[piece.other_segment].length});
          PartCell &cell = cells[piece.part];
          cell = {std::max(cell.shorter, shorter), std::max(cell.longer, longer)};
        }
    return cells;
  }
} // namespace abut
