// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/normal_weight.h>

namespace abut
{
  /// What lies opposite a point of the cut side.
  struct Opposite
  {
    double t;       ///< place on the other side's segment
    double gap;     ///< (other point - point) . normal: positive where the bodies are apart
    Vector2 normal; ///< unit, outward from the cut side
  };

  /**
   * Pairs the points x(s) of a side, the one that is cut into parts, with points y(t) of another side: y - x
   * is parallel to the common normal
   *
   *     n ~ W_y n_x - W_x n_y,   W: the curvature weights of the sides (NormalWeight)
   *
   * which is the normal of the flat or concave side, a direction between both where both are convex, and the
   * face's where a corner presses. Both bodies are loaded along n, so that forces and moments balance. Which
   * of the sides is cut makes no difference to the pairing.
   */
  class CommonNormal
  {
  public:
    /// Both sides must outlive the object.
    CommonNormal(const Trace &cut, const Trace &other);

    /// A segment of the other side with what lies opposite on it.
    struct Facing
    {
      std::size_t segment;
      Opposite opposite;
    };
    /// The first of those that a point of the cut side meets along the common normal: it and the point look
    /// at each other, and the bodies overlap by at most `deepest`.
    std::optional<Facing> facing(std::size_t segment, double s, double deepest) const;
    /// What lies opposite on a segment of the other side that faces the point.
    Opposite project(std::size_t segment, double s, std::size_t other_segment) const;
    /// The place on a segment of the cut side that lies opposite a place of the other side, strictly inside.
    std::optional<double> place_opposite(std::size_t segment, std::size_t other_segment, double t) const;
    /// The places on a segment of the cut side, strictly inside, that lie opposite ends of the other's
    /// segments, in no order.
    std::vector<double> places_opposite_ends(std::size_t segment) const;

  private:
    /// A point of a side with its averaged normal and weight.
    struct Place
    {
      Vector2 point, normal;
      double weight;
    };
    using Ends = std::vector<std::array<Place, 2>>;

    /// Some of the other side's segments, one after the other, and what encloses the places of their ends.
    struct Block
    {
      std::size_t first, last;
      Vector2 centre;
      double radius; ///< of a circle around the points
      Vector2 normal;
      double spread;      ///< of the normals around that one
      double least, most; ///< weights
    };

    static Place place_on(const Trace &side, const NormalWeight &weight, std::size_t segment, double s);
    static Ends ends_of(const Trace &side, const NormalWeight &weight);
    /// The common normal, not of unit length.
    static Vector2 direction(const Place &cut, const Place &other);
    /// By how much the line from x along the normal misses y: positive where y lies to its left.
    static double offset(const Place &cut, const Place &other);

    std::vector<Block> make_blocks() const;
    /// The sign that all offsets of a block have from a place; 0 where they may have both. Exact up to
    /// round-off.
    static int sign_of_offsets(const Place &cut, const Block &block);
    std::optional<double> place_opposite(std::size_t segment, const Place &other) const;

    Facing project(const Place &place, std::size_t other_segment) const;
    /// Whether the normals of both sides are near enough to the line between them, and opposite.
    bool look_at_each_other(const Place &place, const Facing &facing) const;

    const Trace &cut_, &other_;
    NormalWeight cut_weight_, other_weight_;
    Ends cut_ends_, other_ends_;
    std::vector<Block> blocks_; ///< of about as many segments as there are blocks
  };
} // namespace abut
