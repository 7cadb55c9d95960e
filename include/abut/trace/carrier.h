// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/surface.h>

namespace abut
{
  /// The inner bounds of the boxes on a segment, in s: cumulated Gauss-Lobatto weights, 1/2 for degree 1,
  /// 1/6 and 5/6 for degree 2.
  std::vector<double> box_bounds(const Trace &side);

  /// Length of the whole box, also beyond the segment's ends, that a place of a side belongs to.
  double whole_box(const Trace &side, std::size_t segment, double s);

  /// Whether the other side, not the cut one, carries the multipliers of a piece; see Partition.
  bool other_carries(const Surface &surface, const Piece &piece);

  /// The side that carries on a piece, and its segment there.
  struct CarrierSegment
  {
    bool is_other;
    std::size_t side; ///< among the cut sides, or the others
    const Trace *trace;
    std::size_t segment;
  };
  CarrierSegment carrier_segment(const Surface &surface, const Piece &piece);

  /// A node of a side that carries, within one stretch, wherever the node's shape function is not zero.
  struct CarrierNode
  {
    bool is_other;
    std::size_t side;
    unsigned int node;
    std::size_t part; ///< that it lies in
    double arc;       ///< its place along the surface
  };

  /// Every such node, with its place. `pieces` have to know their parts, `stretches` those of every part.
  std::vector<CarrierNode> carrier_nodes(const Surface &surface, const std::vector<CommonNormal> &normals,
                                         const std::vector<Piece> &pieces,
                                         const std::vector<std::size_t> &stretches);
} // namespace abut
