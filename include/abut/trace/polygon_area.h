// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/plane_geometry.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace abut
{
  /**
   * The area inside closed polygons, holes included: whether a point lies in it, and which edge is the
   * nearest. Edges stand in a grid, so that a question costs about as much for many edges as for few.
   */
  class PolygonArea
  {
  public:
    using Edge = std::array<Vector2, 2>; ///< from, to

    /// At least one edge; in any order, all of them together closed.
    explicit PolygonArea(std::vector<Edge> edges);

    const Box &box() const { return box_; }
    /// By the number of edges above the point; on an edge either answer.
    bool contains(const Vector2 &point) const;

    struct Nearest
    {
      std::size_t edge;
      double distance;
    };
    /// Among the edges that count; none where there are none.
    std::optional<Nearest> nearest(const Vector2 &point,
                                   const std::function<bool(std::size_t)> &counts) const;

    /// Where edges cross a line, as shares of the way from its start to its end, in their order.
    std::vector<double> crossings(const Edge &line) const;

  private:
    using Cell = std::array<int, 2>; // column, row

    Cell cell_at(const Vector2 &point) const;
    /// The edges whose boxes reach into a cell.
    const std::vector<std::size_t> &edges_in(const Cell &cell) const
    {
      return grid_[static_cast<std::size_t>(cell[0] * size_[1] + cell[1])];
    }
    /// The nearest in the cells of the ring at a distance from a cell, if nearer than `best`.
    void look_in_ring(const Cell &centre, int ring, const Vector2 &point,
                      const std::function<bool(std::size_t)> &counts, std::optional<Nearest> &best) const;

    std::vector<Edge> edges_;
    Box box_;
    double width_ = 1.; // of a cell
    Cell size_{{1, 1}};
    std::vector<std::vector<std::size_t>> grid_;
  };
} // namespace abut
