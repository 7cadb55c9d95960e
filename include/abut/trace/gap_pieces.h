// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/coupling.h>

namespace abut
{
  /// Where a gap jumps.
  struct GapStep
  {
    Vector2 place = Vector2::Zero(); ///< on the cut side
    double height = 0.;              ///< size of the jump
    std::size_t part = 0;
  };

  struct GapPieces
  {
    std::vector<Piece> pieces;
    std::vector<GapStep> steps;
  };

  /// The pieces of a link as the partition has them: enough for the gap between the sides themselves, which
  /// are polynomials there.
  GapPieces pieces_of_link(const Partition &partition, std::size_t link);

  /**
   * The same for a gap that a formula gives: pieces within which it is not next to a polynomial (waves and
   * steps shorter than a segment) are halved until it is, down to a 64th. What is still none there is
   * followed down to a step, if it is one. `normal`: of the link.
   */
  GapPieces resolved_pieces(const Surface &surface, const CommonNormal &normal, const Partition &partition,
                            std::size_t link, const GapFunction &gap);
} // namespace abut
