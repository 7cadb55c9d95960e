// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/scene/outline_checks.h>

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    std::string to_text(const Vector2 &point)
    {
      std::ostringstream text;
      text << '(' << point.x() << ", " << point.y() << ')';
      return text.str();
    }

    using Polygon = std::vector<Vector2>; // the first point is not repeated

    Polygon polygon_of(const OutlineLoop &loop)
    {
      Polygon polygon{loop.start};
      for (const OutlinePiece &piece : loop.pieces)
      {
        const auto points = points_along(polygon.back(), piece);
        polygon.insert(polygon.end(), points.begin() + 1, points.end());
      }
      polygon.pop_back();
      return polygon;
    }

    void check_closed(const OutlineLoop &loop, const std::string &where)
    {
      if (loop.pieces.empty())
        throw UserError(where + ": the curve from " + to_text(loop.start) + " has no pieces");
      const Vector2 &end = loop.pieces.back().points.back();
      Vector2 before = loop.start;
      for (const OutlinePiece &piece : loop.pieces)
      {
        if ((piece.points.back() - before).norm() == 0.)
          throw UserError(where + ": a piece ends where it begins, at " + to_text(before));
        before = piece.points.back();
      }
      if ((end - loop.start).norm() > 0.)
        throw UserError(where + ": the curve from " + to_text(loop.start) + " ends at " + to_text(end) +
                        ", it must be closed (`-> close` is the line back)");
    }

    /// Whether two chords have a point in common.
    bool meet(const Vector2 &a, const Vector2 &b, const Vector2 &c, const Vector2 &d)
    {
      const auto side = [](const Vector2 &from, const Vector2 &to, const Vector2 &point) {
        return cross(to - from, point - from);
      };
      return side(a, b, c) * side(a, b, d) <= 0. && side(c, d, a) * side(c, d, b) <= 0. &&
             std::max(a.x(), b.x()) >= std::min(c.x(), d.x()) &&
             std::max(c.x(), d.x()) >= std::min(a.x(), b.x()) &&
             std::max(a.y(), b.y()) >= std::min(c.y(), d.y()) &&
             std::max(c.y(), d.y()) >= std::min(a.y(), b.y());
    }

    void check_apart(const Polygon &p, const Polygon &q, const std::string &where)
    {
      const bool same = &p == &q;
      for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = same ? i + 1 : 0; j < q.size(); ++j)
        {
          const std::size_t after_i = (i + 1) % p.size(), after_j = (j + 1) % q.size();
          if (same && (after_i == j || after_j == i))
            continue; // neighbours
          if (meet(p[i], p[after_i], q[j], q[after_j]))
            throw UserError(where + ": its curves meet near " + to_text(p[i]));
        }
    }

    bool is_inside(const Polygon &polygon, const Vector2 &point)
    {
      bool inside = false;
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
          inside = !inside;
      }
      return inside;
    }

    /// A quarter of a circle at most.
    std::vector<Vector2> points_of_arc(const Vector2 &start, const OutlinePiece &arc)
    {
      constexpr int n = 16;
      const Vector2 &centre = arc.points.front();
      const Vector2 from = start - centre, to = arc.points.back() - centre;
      const double angle = turning(from, to);
      std::vector<Vector2> points{start};
      for (int i = 1; i < n; ++i)
        points.push_back(centre + Eigen::Rotation2Dd(angle * i / n) * from);
      points.push_back(arc.points.back());
      return points;
    }
  } // namespace

  std::vector<Vector2> points_along(const Vector2 &start, const OutlinePiece &piece)
  {
    if (piece.kind == OutlinePiece::Kind::arc)
      return points_of_arc(start, piece);
    std::vector<Vector2> points{start};
    points.insert(points.end(), piece.points.begin(), piece.points.end());
    return points;
  }

  void check_outline(const std::vector<OutlineLoop> &loops, const std::string &where)
  {
    if (loops.empty())
      throw UserError(where + ": received no curve, a body needs its outer one");
    std::vector<Polygon> polygons;
    for (const OutlineLoop &loop : loops)
    {
      check_closed(loop, where);
      polygons.push_back(polygon_of(loop));
    }
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        check_apart(polygons[i], polygons[j], where);
    for (std::size_t i = 1; i < polygons.size(); ++i)
      for (std::size_t j = 1; j < polygons.size(); ++j)
        if (i != j && is_inside(polygons[j], polygons[i].front()))
          throw UserError(where + ": the curve from " + to_text(polygons[i].front()) +
                          " lies in a hole, where no body is");
    for (std::size_t i = 1; i < polygons.size(); ++i)
      if (!is_inside(polygons[0], polygons[i].front()))
        throw UserError(where + ": the curve from " + to_text(polygons[i].front()) +
                        " is no hole of the first one, it lies outside");
  }
} // namespace abut
