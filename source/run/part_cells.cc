// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/part_cells.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  const Piece &outermost_piece(const Partition &partition, const std::size_t part, const std::size_t end)
  {
    AssertIndexRange(part, partition.parts().size());
    AssertIndexRange(end, 2);
    const Piece *outermost = nullptr;
    for (const Piece &piece : partition.pieces())
      if (piece.part == part && (!outermost || (piece.arc > outermost->arc) == (end == 1)))
        outermost = &piece;
    Assert(outermost != nullptr, dealii::ExcMessage("a part has pieces"));
    return *outermost;
  }

  bool is_at_symmetry(const ContactSurface &surface, const std::size_t part, const std::size_t end)
  {
    const Piece &outermost = outermost_piece(surface.partition(), part, end);
    const auto pair = std::find_if(surface.pairs().begin(), surface.pairs().end(),
                                   [&](const ContactPair &p) { return p.link() == outermost.link; });
    const auto ends_at_symmetry = [](const ContactBody &side, const std::size_t segment,
                                     const std::size_t e) {
      return side.is_rigid() || side.trace->is_plane_of_symmetry(side.trace->segments()[segment], e);
    };
    return ends_at_symmetry(pair->cut_side(), outermost.cut_segment, end) &&
           ends_at_symmetry(pair->other_side(), outermost.other_segment, 1 - end); // it runs back
  }

  namespace
  {
    /// On both sides of a piece; a rigid side has none.
    PartCell cells_along(const ContactPair &pair, const Piece &piece, const bool other_carries)
    {
      const double cut = pair.cut_side().trace->segments()[piece.cut_segment].length,
                   other = pair.other_side().trace->segments()[piece.other_segment].length;
      if (pair.cut_side().is_rigid())
        return {other, other, other};
      if (pair.other_side().is_rigid())
        return {cut, cut, cut};
      const Trace &carrier = *(other_carries ? pair.other_side() : pair.cut_side()).trace;
      const double share = 2. / std::max(2., static_cast<double>(carrier.basis().degree()));
      return {std::min(cut, other), std::max(cut, other), share * (other_carries ? other : cut)};
    }
  } // namespace

  std::vector<PartCell> part_cells(const ContactSurface &surface)
  {
    std::vector<PartCell> cells;
    for (const Part &part : surface.partition().parts())
      cells.push_back({part.length, part.length, part.length});
    for (const ContactPair &pair : surface.pairs())
    {
      const GapSamples &samples = pair.samples();
      for (std::size_t i = 0; i < samples.pieces.size(); ++i)
      {
        const PartCell along = cells_along(pair, samples.pieces[i], samples.other_carries[i]);
        PartCell &cell = cells[samples.pieces[i].part];
        cell = {std::max(cell.shorter, along.shorter), std::max(cell.longer, along.longer),
                std::max(cell.carrier, along.carrier)};
      }
    }
    return cells;
  }
} // namespace abut
