// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Edges that press into a side which goes on beyond them.

#include <abut/run/checks/validity.h>
#include <abut/run/part_cells.h>
#include <abut/trace/common_normal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace abut
{
  namespace
  {
    /// Whether a place of a side is its start (end = 0) or end (1), or a corner within it, but for a share
    /// `same` of the segment.
    bool side_ends(const Trace &side, const std::size_t segment, const double s, const std::size_t end,
                   const double same = 1e-6)
    {
      if (std::abs(s - static_cast<double>(end)) > same)
        return false;
      const auto next = end == 1 ? side.following(segment) : side.preceding(segment);
      return !next || !side.is_smooth_after(end == 1 ? segment : *next);
    }

    /// The angle of a cell at one of its vertices, in deal.II's order.
    double angle_at(const CellInfo &cell, const std::size_t vertex)
    {
      const std::size_t n = cell.vertices.size(), opposite = n == 4 ? 3 - vertex : n;
      std::vector<Vector2> edges;
      for (std::size_t i = 0; i < n; ++i)
        if (i != vertex && i != opposite)
          edges.push_back((cell.vertices[i] - cell.vertices[vertex]).normalized());
      return std::acos(std::clamp(edges[0].dot(edges[1]), -1., 1.));
    }

    /// Whether the boundary of a body turns by more than 45 degrees, outwards, at a point of it. What a rigid
    /// one does beyond its side is not known: as far as contact goes, it ends there.
    bool is_edge(const Body &body, const Vector2 &point)
    {
      constexpr double same = 1e-6; // of the cell
      double inside = 0.;
      for (const CellInfo &cell : body.cells())
        for (std::size_t i = 0; i < cell.vertices.size(); ++i)
          if ((cell.vertices[i] - point).norm() <= same * cell.diameter)
            inside += angle_at(cell, i);
      return inside < .75 * M_PI;
    }

    /// A place where a side comes to an end.
    struct EdgePlace
    {
      const ContactBody *side;
      std::size_t segment, end;

      Vector2 point() const { return side->trace->point(side->trace->segments()[segment], double(end)); }
    };

    /// The edge that presses into the other side, elastic, at an end of a part: one of the sides ends there,
    /// the other goes on.
    std::optional<EdgePlace> edge_at(const PairResult &pair, const CommonNormal &normal,
                                     const std::size_t part, const std::size_t end)
    {
      const Piece &piece = outermost_piece(pair.surface->partition(), part, end);
      if (piece.link != pair.pair->link())
        return {};
      const ContactBody &cut = pair.pair->cut_side(), &other = pair.pair->other_side();
      const double s = end == 0 ? piece.start : piece.end,
                   t = normal.project(piece.cut_segment, s, piece.other_segment).t;
      const bool cut_ends = side_ends(*cut.trace, piece.cut_segment, s, end),
                 other_ends = side_ends(*other.trace, piece.other_segment, t, 1 - end); // it runs back
      if (cut_ends == other_ends || (cut_ends ? other : cut).is_rigid())
        return {};
      const EdgePlace place = cut_ends ? EdgePlace{&cut, piece.cut_segment, end}
                                       : EdgePlace{&other, piece.other_segment, 1 - end};
      const Trace &trace = *place.side->trace;
      constexpr double near = .01; // planes of symmetry of two bodies may be a little apart
      const bool both_end = cut_ends ? side_ends(*other.trace, piece.other_segment, t, 1 - end, near)
                                     : side_ends(*cut.trace, piece.cut_segment, s, end, near);
      if (both_end && trace.is_plane_of_symmetry(trace.segments()[place.segment], place.end))
        return {};
      return place;
    }

    /// Of the largest pressure. At the distance r from the edge of a right angle between bodies of one
    /// material the pressure goes with r^-.23: from this share on it is the largest one after four splits,
    /// some more where most of it is smooth.
    constexpr double share_of_peak = .5;

    struct PressedEdge
    {
      EdgePlace place;
      double pressure;
    };

    /// The edge with the largest pressure, where that is a share of the largest one of all.
    std::optional<PressedEdge> pressed_edge(const PairResult &pair, const std::vector<BodyResult> &bodies)
    {
      const CommonNormal normal(*pair.pair->cut_side().trace, *pair.pair->other_side().trace);
      std::optional<PressedEdge> most;
      double least = share_of_peak * pair.max_pressure;
      for (const std::size_t part : pair.parts)
        for (const std::size_t end : {0, 1})
        {
          const double pressure = pair.pressures[static_cast<Eigen::Index>(part)];
          if (!pair.presses(part) || pressure < least)
            continue;
          const auto edge = edge_at(pair, normal, part, end);
          if (!edge || !is_edge(*bodies[edge->side->body].body, edge->point()))
            continue;
          most = {*edge, pressure};
          least = pressure;
        }
      return most;
    }
  } // namespace

  Warnings edge_warnings(const PairResult &pair, const std::vector<BodyResult> &bodies)
  {
    const auto edge = pressed_edge(pair, bodies);
    if (!edge)
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "Contact " << pair.pair->name() << ": ";
    if (edge->pressure < pair.max_pressure)
      text << "a pressure of " << edge->pressure << ", while the largest one is " << pair.max_pressure
           << ", ";
    else
      text << "the largest pressure, " << pair.max_pressure << ", ";
    const Vector2 point = edge->place.point();
    text << "stands at (" << point.x() << ", " << point.y() << "), where an edge of body "
         << bodies[edge->place.side->body].body->name()
         << " presses in and the exact pressure is infinite: it grows with every refinement; read the force, "
            "or "
            "round the edge";
    return {{WarningCode::singular_pressure, text.str()}};
  }
} // namespace abut
