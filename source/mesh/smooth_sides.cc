// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/base/plane_geometry.h>
#include <abut/mesh/smooth_sides.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr double straight = 1e-4; // radians: less is rounding of a file's digits

    Vector2 mirrored(const Vector2 &direction, const Vector2 &unit_axis)
    {
      return 2. * unit_axis.dot(direction) * unit_axis - direction;
    }

    /// A piece of the boundary between two of its points, with what is known of its neighbours.
    struct Piece
    {
      Vector2 start, end;
      std::optional<std::size_t> before = {}, after = {}; ///< where the boundary goes on smoothly

      Vector2 chord() const { return end - start; }
    };

    /// The smooth curve through the ends of pieces.
    class SmoothCurve
    {
    public:
      explicit SmoothCurve(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

      /// The point at s of a piece: a cubic between its ends.
      Vector2 point(const std::size_t piece, const double s) const
      {
        const Piece &p = pieces_[piece];
        const Vector2 first = start_tangent(piece), last = end_tangent(piece);
        const double r = 1. - s;
        return r * r * (1. + 2. * s) * p.start + s * s * (1. + 2. * r) * p.end +
               s * r * (r * speed(p, first) * first - s * speed(p, last) * last);
      }
      /// The point at s of n pieces that follow one another; s runs as evenly as their lengths allow.
      Vector2 point(const std::size_t first, const std::size_t n, const double s) const
      {
        double length = 0.;
        for (std::size_t k = 0; k < n; ++k)
          length += pieces_[first + k].chord().norm();
        double left = s * length;
        std::size_t piece = first;
        for (; piece + 1 < first + n && left > pieces_[piece].chord().norm(); ++piece)
          left -= pieces_[piece].chord().norm();
        return point(piece, std::min(left / pieces_[piece].chord().norm(), 1.));
      }
      /// Its ends and cubic alike on a straight line.
      bool is_straight(const std::size_t piece) const
      {
        const Vector2 &chord = pieces_[piece].chord();
        return std::abs(turning(chord, start_tangent(piece))) < straight &&
               std::abs(turning(chord, end_tangent(piece))) < straight;
      }

      /// Whether the boundary has an angle between two pieces.
      bool turns(const std::size_t piece, const std::size_t next) const
      {
        return std::abs(turning(pieces_[piece].chord(), pieces_[next].chord())) >= straight;
      }
      /// Whether the piece continues another one, or is continued, in a straight line.
      bool is_in_line(const std::size_t piece) const
      {
        const Piece &p = pieces_[piece];
        return (p.before && !turns(*p.before, piece)) || (p.after && !turns(piece, *p.after));
      }

    private:
      /// Whether a single edge is the straight line between arcs that touch it: it turns at its ends as the
      /// arcs do over half of their own last edges, and not over half of both.
      bool is_flat(const std::size_t piece) const
      {
        const Piece &p = pieces_[piece];
        const auto before = [&](const std::size_t i) { return pieces_[i].before; };
        const auto after = [&](const std::size_t i) { return pieces_[i].after; };
        const std::optional<bool> at_start = touches(piece, p.before, before),
                                  at_end = touches(piece, p.after, after);
        return (at_start || at_end) && at_start.value_or(true) && at_end.value_or(true);
      }
      /// At one end; nothing where the neighbour's own curvature is not known.
      template <typename Beyond>
      std::optional<bool> touches(const std::size_t piece, const std::optional<std::size_t> neighbour,
                                  const Beyond &beyond) const
      {
        if (!neighbour || !beyond(*neighbour))
          return {};
        const Vector2 own = pieces_[piece].chord(), next = pieces_[*neighbour].chord(),
                      second = pieces_[*beyond(*neighbour)].chord();
        const double curvature = 2. * turning(second, next) / (second.norm() + next.norm()),
                     turn = turning(next, own);
        const double as_line = .5 * curvature * next.norm(), as_arc = as_line + .5 * curvature * own.norm();
        return std::abs(turn - as_line) < std::abs(turn - as_arc);
      }
      /// Of the parameter, at an end with this tangent: exact for arcs up to the fifth power of their angle.
      static double speed(const Piece &piece, const Vector2 &tangent)
      {
        const double length = piece.chord().norm();
        return 2. * length / (1. + piece.chord().dot(tangent) / length);
      }
      /// Of the circle through a point and its neighbours; where a straight run ends, of that run.
      Vector2 tangent_between(const std::size_t piece, const std::size_t next) const
      {
        const Vector2 a = pieces_[piece].chord(), b = pieces_[next].chord();
        const bool flat = is_in_line(piece) || is_flat(piece), next_flat = is_in_line(next) || is_flat(next);
        if (flat != next_flat)
          return (flat ? a : b).normalized();
        return (a / a.squaredNorm() + b / b.squaredNorm()).normalized();
      }
      Vector2 start_tangent(const std::size_t piece) const
      {
        const Piece &p = pieces_[piece];
        if (p.before)
          return tangent_between(*p.before, piece);
        const Vector2 axis = p.chord().normalized();
        return p.after ? mirrored(tangent_between(piece, *p.after), axis) : axis;
      }
      Vector2 end_tangent(const std::size_t piece) const
      {
        const Piece &p = pieces_[piece];
        if (p.after)
          return tangent_between(piece, *p.after);
        const Vector2 axis = p.chord().normalized();
        return p.before ? mirrored(tangent_between(*p.before, piece), axis) : axis;
      }

      std::vector<Piece> pieces_;
    };

    /// Joins pieces inside edges, and edges where the boundary is one smooth side.
    class Joints
    {
    public:
      Joints(const RawMesh &mesh, const std::vector<std::vector<Vector2>> &between) : mesh_(mesh)
      {
        for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i)
          add(mesh.boundary_edges[i], between.empty() ? std::vector<Vector2>() : between[i]);
      }

      std::vector<Piece> joined(const double corner_angle)
      {
        std::map<unsigned int, std::vector<std::size_t>> starting_at;
        for (std::size_t i = 0; i < mesh_.boundary_edges.size(); ++i)
          starting_at[mesh_.boundary_edges[i].vertices[0]].push_back(i);
        for (std::size_t i = 0; i < mesh_.boundary_edges.size(); ++i)
        {
          const auto &next = starting_at.at(mesh_.boundary_edges[i].vertices[1]);
          if (next.size() == 1 && are_one_side(mesh_.boundary_edges[i], mesh_.boundary_edges[next[0]]))
            join(first_[i + 1] - 1, first_[next[0]], corner_angle);
        }
        part_straight_runs();
        return pieces_;
      }
      /// The pieces of an edge are first()[edge] ... first()[edge + 1] - 1.
      const std::vector<std::size_t> &first() const { return first_; }

    private:
      static bool are_one_side(const RawMesh::BoundaryEdge &a, const RawMesh::BoundaryEdge &b)
      {
        return a.side == b.side && a.material == b.material;
      }
      void add(const RawMesh::BoundaryEdge &edge, const std::vector<Vector2> &between)
      {
        Vector2 start = mesh_.vertices[edge.vertices[0]];
        for (std::size_t i = 0; i <= between.size(); ++i)
        {
          const Vector2 end = i < between.size() ? between[i] : mesh_.vertices[edge.vertices[1]];
          pieces_.push_back({start, end});
          if (i > 0)
            connect(pieces_.size() - 2, pieces_.size() - 1);
          start = end;
        }
        first_.push_back(pieces_.size());
      }
      void join(const std::size_t piece, const std::size_t next, const double corner_angle)
      {
        if (std::abs(turning(pieces_[piece].chord(), pieces_[next].chord())) < corner_angle)
          connect(piece, next);
      }
      /// Where two straight runs meet at an angle is a corner, however blunt.
      void part_straight_runs()
      {
        const SmoothCurve curve(pieces_);
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          if (const auto next = pieces_[i].after;
              next && curve.is_in_line(i) && curve.is_in_line(*next) && curve.turns(i, *next))
          {
            pieces_[i].after.reset();
            pieces_[*next].before.reset();
          }
      }
      void connect(const std::size_t piece, const std::size_t next)
      {
        pieces_[piece].after = next;
        pieces_[next].before = piece;
      }

      const RawMesh &mesh_;
      std::vector<Piece> pieces_;
      std::vector<std::size_t> first_{0};
    };
  } // namespace

  void smooth_sides(RawMesh &mesh, const std::vector<std::vector<Vector2>> &between,
                    const double corner_angle)
  {
    Joints joints(mesh, between);
    const SmoothCurve curve(joints.joined(corner_angle));
    for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i)
    {
      const std::size_t first = joints.first()[i], n = joints.first()[i + 1] - first;
      bool is_line = true;
      for (std::size_t k = 0; k < n; ++k)
        is_line = is_line && curve.is_straight(first + k);
      if (is_line)
        continue;
      const LagrangeBasis basis(n == 1 ? 3 : 8);
      for (const double s : basis.nodes())
        mesh.boundary_edges[i].curve.push_back(curve.point(first, n, s));
    }
  }
} // namespace abut
