// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/run/checks/unpaired_overlap.h>
#include <abut/trace/polygon_area.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace abut
{
  namespace
  {
    using SideSet = std::set<std::size_t>;
    using SidePairs =
        std::set<std::pair<std::size_t, std::size_t>>; ///< of two bodies, those that a contact joins

    /// The polygons of a displaced body, edge by edge.
    struct DisplacedBody
    {
      std::vector<BoundarySide> sides;
      std::vector<PolygonArea::Edge> edges;
      std::vector<std::size_t> side_of;    ///< each edge
      std::vector<double> slack;           ///< what the edge is off the body's true boundary
      std::vector<SideSet> sides_at_start; ///< those that meet where the edge begins
    };

    /// The sides that meet at a node, by its first unknown.
    std::map<unsigned int, SideSet> sides_at_nodes(const std::vector<BoundarySide> &sides)
    {
      std::map<unsigned int, SideSet> meet;
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (const auto &dofs : sides[i].curve.node_dofs())
          meet[dofs[0]].insert(i);
      return meet;
    }

    DisplacedBody displaced(const Body &body, const Eigen::VectorXd &displacement)
    {
      DisplacedBody result;
      result.sides = body.boundary();
      const auto meet = sides_at_nodes(result.sides);
      for (std::size_t i = 0; i < result.sides.size(); ++i)
      {
        const Trace &curve = result.sides[i].curve;
        for (const Segment &segment : curve.segments())
        {
          const std::size_t n = std::max(segment.nodes.size(), segment.points.size()) - 1;
          for (std::size_t k = 0; k < n; ++k)
          {
            std::array<Vector2, 3> from, to; // start, middle, end
            for (const std::size_t j : {0, 1, 2})
            {
              const double s =
                  (static_cast<double>(k) + .5 * static_cast<double>(j)) / static_cast<double>(n);
              from[j] = curve.point(segment, s);
              to[j] = from[j];
              if (displacement.size() > 0)
                to[j] += curve.displacement(segment, s, displacement);
            }
            // A chord for a curve, and what a rotation adds to a displacement that is linear in it.
            const double sagitta = (to[1] - .5 * (to[0] + to[2])).norm(),
                         turn = std::abs(abut::turning(from[2] - from[0], to[2] - to[0])),
                         moved = std::max((to[0] - from[0]).norm(), (to[2] - from[2]).norm());
            result.edges.push_back({{to[0], to[2]}});
            result.side_of.push_back(i);
            result.slack.push_back(2. * sagitta + .5 * turn * moved);
            result.sides_at_start.push_back(k == 0 ? meet.at(curve.node_dofs()[segment.nodes.front()][0])
                                                   : SideSet{i});
          }
        }
      }
      return result;
    }

    bool is_called(const BoundarySide &side, const std::string &name)
    {
      const auto has = [&](const std::string &part) {
        return std::count(side.names.begin(), side.names.end(), part) > 0;
      };
      const std::vector<std::string> parts = split_outside_parentheses(name, '+');
      return has(name) || std::any_of(parts.begin(), parts.end(), has);
    }

    /// A name that is no number, where there is one.
    std::string name_of(const BoundarySide &side)
    {
      return side.names.empty() ? "0" : side.names.back();
    }

    /// Two bodies, the one whose points are looked at and the other, within which they may lie.
    class OverlapSearch
    {
    public:
      OverlapSearch(const DisplacedBody &body, const PolygonArea &area, const DisplacedBody &other,
                    const PolygonArea &other_area, const SidePairs &pairs)
          : body_(body), area_(area), other_(other), other_area_(other_area), pairs_(pairs),
            round_(touching * std::min(area.box().diagonal(), other_area.box().diagonal()))
      {}

      struct Found
      {
        std::size_t side, other_side;
        Vector2 place;
        double depth = 0.;
      };

      Found deepest()
      {
        for (std::size_t k = 0; k < body_.edges.size(); ++k)
        {
          if (is_far(body_.edges[k]) || body_.sides[body_.side_of[k]].is_glued)
            continue;
          look_at(k, body_.edges[k][0], body_.sides_at_start[k]);
          // A corner of the other body, or all of it, may lie between the ends.
          const std::vector<double> shares = other_area_.crossings(body_.edges[k]);
          for (std::size_t i = 0; i + 1 < shares.size(); ++i)
          {
            const double middle = .5 * (shares[i] + shares[i + 1]);
            look_at(k, body_.edges[k][0] + middle * (body_.edges[k][1] - body_.edges[k][0]),
                    {body_.side_of[k]});
          }
        }
        return found_;
      }

    private:
      /// Of the smaller body's size: how well curves meet that should touch.
      static constexpr double touching = 1e-6;

      bool is_far(const PolygonArea::Edge &edge) const
      {
        const Box &box = other_area_.box();
        return (edge[0].cwiseMax(edge[1]).array() < box.low.array()).any() ||
               (edge[0].cwiseMin(edge[1]).array() > box.high.array()).any();
      }

      bool joined(const SideSet &sides, const std::size_t other_side) const
      {
        return std::any_of(sides.begin(), sides.end(), [&](const std::size_t side) {
          return pairs_.count({side, other_side}) > 0;
        });
      }

      double length(const PolygonArea::Edge &edge) const { return (edge[1] - edge[0]).norm(); }

      void look_at(const std::size_t edge, const Vector2 &point, const SideSet &sides)
      {
        if (!other_area_.contains(point))
          return;
        const auto nearest = other_area_.nearest(
            point, [&](const std::size_t k) { return !other_.sides[other_.side_of[k]].is_glued; });
        if (!nearest || joined(sides, other_.side_of[nearest->edge]))
          return;
        const double depth = nearest->distance;
        if (!(depth > std::max(found_.depth, round_ + body_.slack[edge] + other_.slack[nearest->edge])) ||
            is_beside_pair(edge, point, sides, *nearest))
          return;
        found_ = {body_.side_of[edge], other_.side_of[nearest->edge], point, depth};
      }

      /// Whether sides that a pair joins meet there, with a corner.
      bool is_beside_pair(const std::size_t edge, const Vector2 &point, const SideSet &sides,
                          const PolygonArea::Nearest &nearest) const
      {
        const double near = 2. * nearest.distance,
                     cell = std::max(length(body_.edges[edge]), length(other_.edges[nearest.edge]));
        const auto own = area_.nearest(point, [&](const std::size_t k) {
          return pairs_.count({body_.side_of[k], other_.side_of[nearest.edge]}) > 0;
        });
        if (own && own->distance <= near)
          return true;
        const auto others =
            other_area_.nearest(point, [&](const std::size_t k) { return joined(sides, other_.side_of[k]); });
        return others && others->distance <= std::max(near, cell);
      }

      const DisplacedBody &body_;
      const PolygonArea &area_;
      const DisplacedBody &other_;
      const PolygonArea &other_area_;
      const SidePairs &pairs_;
      double round_;
      Found found_;
    };

    bool is_fixed(const Body &body)
    {
      return body.description().is_rigid && body.free_rigid_motions().empty() && !body.resultant();
    }

    /// The sides of two bodies that a contact joins.
    SidePairs joined_sides(const Scene &scene, const std::array<std::string, 2> &names,
                           const DisplacedBody &a, const DisplacedBody &b)
    {
      SidePairs pairs;
      for (const ContactDescription &contact : scene.contacts)
        for (const auto &[first, second] :
             {std::pair(contact.slave, contact.master), std::pair(contact.master, contact.slave)})
          if (first.body == names[0] && second.body == names[1])
            for (std::size_t i = 0; i < a.sides.size(); ++i)
              for (std::size_t j = 0; j < b.sides.size(); ++j)
                if (is_called(a.sides[i], first.boundary) && is_called(b.sides[j], second.boundary))
                  pairs.insert({i, j});
      return pairs;
    }

    SidePairs swapped(const SidePairs &pairs)
    {
      SidePairs result;
      for (const auto &[a, b] : pairs)
        result.insert({b, a});
      return result;
    }
  } // namespace

  std::vector<UnpairedOverlap> unpaired_overlaps(const Scene &scene, const Model &model,
                                                 const std::vector<Eigen::VectorXd> &displacements)
  {
    const std::size_t n = model.bodies().size();
    if (n < 2)
      return {};
    std::vector<DisplacedBody> bodies;
    std::vector<PolygonArea> areas;
    for (std::size_t a = 0; a < n; ++a)
    {
      bodies.push_back(
          displaced(*model.bodies()[a], displacements.empty() ? Eigen::VectorXd() : displacements[a]));
      areas.emplace_back(bodies.back().edges);
    }
    std::vector<UnpairedOverlap> overlaps;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
      {
        if (is_fixed(*model.bodies()[a]) && is_fixed(*model.bodies()[b]))
          continue;
        const auto pairs = joined_sides(scene, {{model.bodies()[a]->name(), model.bodies()[b]->name()}},
                                        bodies[a], bodies[b]),
                   back = swapped(pairs);
        const auto of_a = OverlapSearch(bodies[a], areas[a], bodies[b], areas[b], pairs).deepest(),
                   of_b = OverlapSearch(bodies[b], areas[b], bodies[a], areas[a], back).deepest();
        if (std::max(of_a.depth, of_b.depth) > 0.)
        {
          const bool first = of_a.depth >= of_b.depth;
          const auto &found = first ? of_a : of_b;
          overlaps.push_back({{{a, b}},
                              {{name_of(bodies[a].sides[first ? found.side : found.other_side]),
                                name_of(bodies[b].sides[first ? found.other_side : found.side])}},
                              found.place,
                              found.depth});
        }
      }
    return overlaps;
  }
} // namespace abut
