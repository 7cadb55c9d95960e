// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/surface.h>

namespace abut
{
  /**
   * The segments of a surface's cut sides in a row: each is followed by the one that begins where it ends,
   * also across sides and bodies, as long as the surface turns there by less than 45 degrees. Places along it
   * are lengths; rows that do not hang together follow one another.
   */
  class SurfaceLine
  {
  public:
    struct Place
    {
      std::size_t row;
      double start; ///< of the segment's s = 0
    };
    struct Row
    {
      double start, length;
      bool closed;
    };

    explicit SurfaceLine(const Surface &surface);

    const Place &place(const std::size_t cut_side, const std::size_t segment) const
    {
      return places_[cut_side][segment];
    }
    const Row &row(const std::size_t index) const { return rows_[index]; }

  private:
    /// A segment by its side and number.
    struct Id
    {
      std::size_t side, segment;
    };
    static const Segment &at(const Surface &surface, const Id &id)
    {
      return surface.cut[id.side].trace->segments()[id.segment];
    }
    /// The segment of another side that begins next to the end of this one or, backwards, ends next to its
    /// start.
    std::optional<Id> across(const Surface &surface, const Id &id, bool forwards) const;
    std::optional<Id> next(const Surface &surface, const Id &id) const;
    void lay_row(const Surface &surface, const Id &first, std::vector<std::vector<bool>> &laid);

    std::vector<std::vector<Place>> places_;
    std::vector<Row> rows_;
  };

  /// Of a box: what may be uncovered within a part, and how short one may be.
  constexpr double smallest_share_of_box = .3;
} // namespace abut
