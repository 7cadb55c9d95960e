// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/bodies/rigid/rigid_outline.h>
#include <abut/scene/shape_entry.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace abut
{
  namespace
  {
    constexpr int arcs_in_a_quarter = 16;
    constexpr int pieces_of_a_line = 64; // for loads that change along it
    constexpr int pieces_of_a_span = 8;  // of a spline
    const std::string rest = "0";        // the side of pieces without a name

    using Curve = std::function<Vector2(double)>;

    std::vector<Curve> arcs(const Vector2 &start, const OutlinePiece &piece)
    {
      const Vector2 centre = piece.points.front(), from = start - centre;
      const double angle = turning(from, piece.points.back() - centre);
      const int n =
          std::max(1, static_cast<int>(std::ceil(arcs_in_a_quarter * std::abs(angle) / (.5 * M_PI) - 1e-9)));
      std::vector<Curve> curves;
      for (int i = 0; i < n; ++i)
        curves.push_back([=](const double s) -> Vector2 {
          return centre + Eigen::Rotation2Dd(angle * (i + s) / n) * from;
        });
      return curves;
    }

    /// Pieces [from, to] of a curve on [0, 1].
    std::vector<Curve> pieces_of(const Curve &curve, const int n)
    {
      std::vector<Curve> pieces;
      for (int i = 0; i < n; ++i)
        pieces.push_back([=](const double s) { return curve((i + s) / n); });
      return pieces;
    }

    /// The largest distance between a curve and the polynomial through its places at the nodes.
    double error_of_polynomial(const Curve &curve)
    {
      const LagrangeBasis basis(RigidOutline::degree);
      double largest = 0.;
      for (const double s : {.07, .25, .4, .6, .75, .93})
      {
        const Eigen::VectorXd values = basis.values(s);
        Vector2 sum = Vector2::Zero();
        for (Eigen::Index i = 0; i < values.size(); ++i)
          sum += values[i] * curve(basis.nodes()[i]);
        largest = std::max(largest, (sum - curve(s)).norm());
      }
      return largest;
    }

    /// y = height(x), halved until polynomials are next to it.
    class Graph
    {
    public:
      Graph(const Vector2 &start, const OutlinePiece &piece, const std::string &where)
          : height_(*piece.height), from_(start.x()), to_(piece.points.back().x()),
            size_((piece.points.back() - start).norm()), where_(where)
      {
        constexpr int n = 16; // at least
        for (int i = 0; i < n; ++i)
          add(static_cast<double>(i) / n, 1. / n);
      }
      const std::vector<Curve> &pieces() const { return pieces_; }

    private:
      void add(const double first, const double step)
      {
        constexpr double wanted = 1e-9, allowed = 1e-6, shortest = 1e-4; // of the whole piece
        const Curve curve = [height = height_, from = from_, to = to_, first,
                             step](const double s) -> Vector2 {
          const double x = from + (first + s * step) * (to - from);
          return {x, height({x, 0.})};
        };
        const double error = error_of_polynomial(curve);
        if (error > wanted * size_ && step > shortest)
        {
          add(first, .5 * step);
          add(first + .5 * step, .5 * step);
          return;
        }
        if (error > allowed * size_)
          throw UserError(where_ + ": the formula `" + height_.text() +
                          "` changes too fast to be followed; give its parts pieces of their own");
        pieces_.push_back(curve);
      }

      const Expression &height_;
      double from_, to_, size_;
      const std::string &where_;
      std::vector<Curve> pieces_;
    };

    /// Catmull and Rom's cubics, whose tangent at a point is parallel to the chord between its neighbours.
    std::vector<Curve> cubics(const Vector2 &start, const OutlinePiece &piece)
    {
      std::vector<Vector2> points{start};
      points.insert(points.end(), piece.points.begin(), piece.points.end());
      const std::size_t n = points.size();
      std::vector<Vector2> tangents{points[1] - points[0]};
      for (std::size_t i = 1; i + 1 < n; ++i)
        tangents.push_back(.5 * (points[i + 1] - points[i - 1]));
      tangents.push_back(points[n - 1] - points[n - 2]);
      std::vector<Curve> curves;
      for (std::size_t i = 0; i + 1 < n; ++i)
      {
        const Curve span = [a = points[i], b = points[i + 1], from = tangents[i],
                            to = tangents[i + 1]](const double s) -> Vector2 {
          const double r = 1. - s;
          return r * r * (1. + 2. * s) * a + s * s * (3. - 2. * s) * b + s * r * (r * from - s * to);
        };
        const std::vector<Curve> pieces = pieces_of(span, pieces_of_a_span);
        curves.insert(curves.end(), pieces.begin(), pieces.end());
      }
      return curves;
    }

    std::vector<Curve> curves_of(const Vector2 &start, const OutlinePiece &piece, const std::string &where)
    {
      if (piece.height)
        return Graph(start, piece, where).pieces();
      switch (piece.kind)
      {
      case OutlinePiece::Kind::arc:
        return arcs(start, piece);
      case OutlinePiece::Kind::spline:
        return cubics(start, piece);
      case OutlinePiece::Kind::line:
        break;
      }
      const Curve line = [start, end = piece.points.back()](const double s) -> Vector2 {
        return start + s * (end - start);
      };
      return pieces_of(line, pieces_of_a_line);
    }

    /// Twice the area inside, positive where the points run counter-clockwise.
    double twice_the_area(const std::vector<Vector2> &points)
    {
      double area = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
        area += cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
      return area;
    }

    ShapeEntry rigid_outline_entry()
    {
      ShapeEntry entry{"rigid outline", "an obstacle that does not deform and has no mesh, inside the curves "
                                        "of Outline, sides by the names given there, 0: the rest"};
      entry.takes_outline = true;
      entry.is_rigid = true;
      return entry;
    }

    const Registered<ShapeEntry> registered_rigid_outline(rigid_outline_entry());
  } // namespace

  RigidOutline::RigidOutline(const BodyDescription &body)
      : body_(body.name),
        has_names_(std::any_of(body.outline.begin(), body.outline.end(), [](const auto &loop) {
          return std::any_of(loop.pieces.begin(), loop.pieces.end(),
                             [](const OutlinePiece &piece) { return !piece.side.empty(); });
        }))
  {
    Assert(body.is_rigid && !body.outline.empty(), dealii::ExcMessage("a rigid body has an outline"));
    for (const OutlineLoop &loop : body.outline)
      add_loop(loop, body.placement, &loop != &body.outline.front());
  }

  void RigidOutline::add_loop(const OutlineLoop &loop, const Placement &placement, const bool is_hole)
  {
    const LagrangeBasis basis(degree);
    std::vector<Vector2> places; // without the end of each segment, where the next one begins
    std::vector<std::string> sides;
    Vector2 start = loop.start;
    for (const OutlinePiece &piece : loop.pieces)
    {
      ++n_pieces_;
      const std::string name = has_names_ ? rest : std::to_string(n_pieces_);
      for (const Curve &curve : curves_of(start, piece, "Body " + body_ + "/Outline"))
      {
        sides.push_back(piece.side.empty() ? name : piece.side);
        for (Eigen::Index i = 0; i < degree; ++i)
          places.push_back(placement.point_to_world(curve(basis.nodes()[i])));
      }
      start = piece.points.back();
    }
    if ((twice_the_area(places) > 0.) == is_hole)
    {
      std::reverse(places.begin() + 1, places.end());
      std::reverse(sides.begin(), sides.end());
    }

    const auto first = static_cast<unsigned int>(nodes_.places.size()),
               n = static_cast<unsigned int>(places.size());
    loops_.emplace_back();
    for (unsigned int i = 0; i < n; ++i)
    {
      loops_.back().push_back(first + i);
      nodes_.dofs.push_back({{2 * (first + i), 2 * (first + i) + 1}});
    }
    nodes_.places.insert(nodes_.places.end(), places.begin(), places.end());
    segments_.emplace_back();
    for (unsigned int k = 0; k < sides.size(); ++k)
    {
      segments_.back().push_back({sides[k], {}});
      for (unsigned int i = 0; i <= degree; ++i)
        segments_.back().back().nodes.push_back(first + (k * degree + i) % n);
    }
  }

  std::vector<double> RigidOutline::lengths_at_nodes() const
  {
    const Eigen::VectorXd shares = LagrangeBasis(degree).integrals();
    std::vector<double> lengths(nodes_.places.size(), 0.);
    for (const auto &loop : segments_)
      for (const Segment &segment : loop)
      {
        const double chord =
            (nodes_.places[segment.nodes.back()] - nodes_.places[segment.nodes.front()]).norm();
        for (std::size_t i = 0; i < segment.nodes.size(); ++i)
          lengths[segment.nodes[i]] += chord * shares[static_cast<Eigen::Index>(i)];
      }
    return lengths;
  }

  std::vector<std::string> RigidOutline::side_names() const
  {
    std::set<std::string> names;
    for (const auto &loop : segments_)
      for (const Segment &segment : loop)
        names.insert(segment.side);
    return {names.begin(), names.end()};
  }

  Trace RigidOutline::side(const std::string &name) const
  {
    const std::vector<std::string> known = side_names();
    std::set<std::string> parts;
    for (const std::string &part : split_outside_parentheses(name, '+'))
    {
      if (std::count(known.begin(), known.end(), part) == 0)
      {
        std::string all;
        for (const std::string &side : known)
          all += (all.empty() ? "" : ", ") + side;
        throw UserError("Body " + body_ + " has no side '" + part + "'; its sides are " + all);
      }
      if (!parts.insert(part).second)
        throw UserError("Body " + body_ + ": the side `" + name + "` has `" + part + "` twice");
    }

    std::vector<abut::Segment> segments;
    std::vector<std::array<unsigned int, 2>> node_dofs;
    std::map<unsigned int, unsigned int> trace_nodes; // by the outline's
    for (const auto &loop : segments_)
    {
      const auto belongs = [&](const Segment &segment) { return parts.count(segment.side) > 0; };
      // A run that goes on beyond the loop's first segment begins before it.
      const auto gap = std::find_if_not(loop.rbegin(), loop.rend(), belongs).base();
      std::vector<Segment> ordered(gap, loop.end());
      ordered.insert(ordered.end(), loop.begin(), gap);
      for (const Segment &segment : ordered)
      {
        if (!belongs(segment))
          continue;
        segments.emplace_back();
        for (const unsigned int node : segment.nodes)
        {
          const auto [found, is_new] = trace_nodes.emplace(node, static_cast<unsigned int>(node_dofs.size()));
          if (is_new)
            node_dofs.push_back(nodes_.dofs[node]);
          segments.back().points.push_back(nodes_.places[node]);
          segments.back().nodes.push_back(found->second);
        }
      }
    }
    return Trace(degree, degree, std::move(segments), std::move(node_dofs));
  }
} // namespace abut
