// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/glue.h>
#include <abut/bodies/rigid/rigid_outline.h>
#include <abut/mesh/body_mesh.h>
#include <abut/run/find_contacts.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double default_share = .01; // of the smallest body's extent

    struct Edge
    {
      Vector2 start, end; // the body on the left
    };

    /// A side of a body as the polygon of its mesh.
    struct Polyline
    {
      std::string name;
      std::vector<Edge> edges;
    };

    Vector2 to_vector2(const dealii::Point<2> &point)
    {
      return Vector2(point[0], point[1]);
    }

    /// Every side once: by its name rather than by its number.
    std::vector<Polyline> sides_of(const BodyMesh &mesh)
    {
      std::map<dealii::types::boundary_id, Polyline> sides;
      for (const auto &[name, id] : mesh.boundaries)
        if (std::string &known = sides[id].name; known.empty() || known == std::to_string(id))
          known = name;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            Edge edge{to_vector2(face->vertex(0)), to_vector2(face->vertex(1))};
            if (cross(edge.end - edge.start, to_vector2(cell->center()) - edge.start) < 0.)
              std::swap(edge.start, edge.end);
            sides[face->boundary_id()].edges.push_back(edge);
          }
      std::vector<Polyline> result;
      for (auto &[id, side] : sides)
        result.push_back(std::move(side));
      return result;
    }

    std::vector<Polyline> sides_of(const RigidOutline &outline)
    {
      std::vector<Polyline> sides;
      for (const std::string &name : outline.side_names())
      {
        const Trace trace = outline.side(name);
        sides.push_back({name, {}});
        for (const Segment &segment : trace.segments())
          sides.back().edges.push_back({segment.points.front(), segment.points.back()});
      }
      return sides;
    }

    std::vector<Polyline> sides_of(const BodyDescription &body)
    {
      if (body.is_rigid)
        return sides_of(RigidOutline(body));
      auto mesh = make_mesh(body);
      unite_named_sides(*mesh, body);
      std::vector<Polyline> sides = sides_of(*mesh);
      if (!body.is_glued())
        return sides;
      const Space space(std::move(mesh), body.degree);
      for (const GluedSides &pair : find_glue(space, body, {}))
        sides.erase(std::remove_if(sides.begin(), sides.end(),
                                   [&](const Polyline &side) {
                                     return side.name == pair.slave_name || side.name == pair.master_name;
                                   }),
                    sides.end());
      return sides;
    }

    /// The distance from the ends and the middle of an edge to another that faces it and reaches as far;
    /// infinite where it does not.
    double distance(const Edge &edge, const Edge &other)
    {
      const double opposed = -std::sqrt(.5); // cosine of 135 degrees
      constexpr double end = 1e-9;           // of the edge: what only meets corner to corner does not face
      double smallest = std::numeric_limits<double>::infinity();
      const Vector2 along = other.end - other.start;
      if ((edge.end - edge.start).normalized().dot(along.normalized()) > opposed)
        return smallest;
      for (const Vector2 &point : {edge.start, Vector2(.5 * (edge.start + edge.end)), edge.end})
        if (const double s = along.dot(point - other.start) / along.squaredNorm(); s > end && s < 1. - end)
          smallest = std::min(smallest, (other.start + s * along - point).norm());
      return smallest;
    }

    /// The distance from a corner of a side, where an edge is followed by the next, to an edge that faces it.
    double distance_of_corner(const Edge &before, const Edge &after, const Edge &other)
    {
      const Vector2 along = other.end - other.start, tip = after.start;
      const Vector2 outward =
          outward_normal(before.end - before.start) + outward_normal(after.end - after.start);
      const double s = along.dot(tip - other.start) / along.squaredNorm();
      if (s < 0. || s > 1. || outward.normalized().dot(outward_normal(along)) > -std::sqrt(.5))
        return std::numeric_limits<double>::infinity();
      return (other.start + s * along - tip).norm();
    }

    double distance_of_corners(const Polyline &a, const Polyline &b)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const Edge &before : a.edges)
        for (const Edge &after : a.edges)
          if (before.end == after.start)
            for (const Edge &other : b.edges)
              smallest = std::min(smallest, distance_of_corner(before, after, other));
      return smallest;
    }

    double distance(const Polyline &a, const Polyline &b)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const Edge &edge : a.edges)
        for (const Edge &other : b.edges)
          smallest = std::min({smallest, distance(edge, other), distance(other, edge)});
      return std::min({smallest, distance_of_corners(a, b), distance_of_corners(b, a)});
    }

    double extent(const std::vector<Polyline> &sides)
    {
      Vector2 low = sides[0].edges[0].start, high = low;
      for (const Polyline &side : sides)
        for (const Edge &edge : side.edges)
        {
          low = low.cwiseMin(edge.start);
          high = high.cwiseMax(edge.start);
        }
      return (high - low).norm();
    }

    std::string name_of(const Side &slave, const Side &master)
    {
      std::string name = slave.body + '.' + slave.boundary + '-' + master.body + '.' + master.boundary;
      for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '_')
          c = '_';
      return name;
    }

    class Search
    {
    public:
      explicit Search(const Scene &scene) : scene_(scene)
      {
        double smallest = std::numeric_limits<double>::infinity();
        for (const BodyDescription &body : scene.bodies)
        {
          sides_.push_back(sides_of(body));
          smallest = std::min(smallest, extent(sides_.back()));
        }
        reach_ = scene.contact_distance > 0. ? scene.contact_distance : default_share * smallest;
      }

      std::vector<ContactDescription> contacts()
      {
        std::vector<ContactDescription> found;
        for (std::size_t a = 0; a < sides_.size(); ++a)
          for (std::size_t b = a + 1; b < sides_.size(); ++b)
            for (const Polyline &slave : sides_[a])
              for (const Polyline &master : sides_[b])
                if (!(scene_.bodies[a].is_rigid && scene_.bodies[b].is_rigid) && is_near(slave, master))
                {
                  found.emplace_back();
                  found.back().slave = {scene_.bodies[a].name, slave.name};
                  found.back().master = {scene_.bodies[b].name, master.name};
                  found.back().name = name_of(found.back().slave, found.back().master);
                }
        if (found.empty())
          throw UserError(refusal());
        return found;
      }

    private:
      bool is_near(const Polyline &a, const Polyline &b)
      {
        const double between = distance(a, b);
        nearest_ = std::min(nearest_, between);
        return between <= reach_;
      }

      std::string refusal() const
      {
        std::ostringstream text;
        text << "Contacts: received `automatic`, but no sides of two bodies face each other within " << reach_
             << " (Contact distance)";
        if (nearest_ < std::numeric_limits<double>::infinity())
          text << "; the nearest that do are " << nearest_ << " apart";
        return text.str();
      }

      const Scene &scene_;
      std::vector<std::vector<Polyline>> sides_; // of each body
      double reach_, nearest_ = std::numeric_limits<double>::infinity();
    };
  } // namespace

  std::optional<Scene> with_found_contacts(const Scene &scene)
  {
    if (!scene.finds_contacts)
      return {};
    Scene completed = scene;
    completed.contacts = Search(scene).contacts();
    return completed;
  }
} // namespace abut
