// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/gathered.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/own_cells.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace abut
{
  namespace
  {
    Vector2 to_vector2(const dealii::Point<2> &point)
    {
      return Vector2(point[0], point[1]);
    }

    /// The mean of the outward unit normal over a side, of its straight edges.
    Vector2 mean_normal(const BodyMesh &mesh, const dealii::types::boundary_id side)
    {
      Vector2 sum = Vector2::Zero();
      double length = 0.;
      for (const auto &cell : own_cells(mesh.triangulation))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == side)
          {
            const Vector2 a = to_vector2(face->vertex(0)), b = to_vector2(face->vertex(1));
            const Vector2 normal((b - a).y(), (a - b).x());
            const bool outward = normal.dot(a - to_vector2(cell->center())) > 0.;
            sum += outward ? normal : Vector2(-normal);
            length += (b - a).norm();
          }
      const std::vector<Vector2> sums = gathered<Vector2>(mesh.processes, {sum});
      const std::vector<double> lengths = gathered<double>(mesh.processes, {length});
      sum = std::accumulate(sums.begin(), sums.end(), Vector2(0., 0.));
      length = std::accumulate(lengths.begin(), lengths.end(), 0.);
      Assert(length > 0., dealii::ExcMessage("a side has edges"));
      return sum / length;
    }

    std::vector<Vector2> boundary_vertices(const BodyMesh &mesh)
    {
      std::set<unsigned int> numbers;
      for (const auto &cell : own_cells(mesh.triangulation))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            numbers.insert({face->vertex_index(0), face->vertex_index(1)});
      std::vector<Vector2> vertices;
      for (const unsigned int number : numbers)
        vertices.push_back(to_vector2(mesh.triangulation.get_vertices()[number]));
      return gathered(mesh.processes, std::move(vertices));
    }

    double extent(const std::vector<Vector2> &points, const Vector2 &direction)
    {
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const Vector2 &point : points)
      {
        lowest = std::min(lowest, point.dot(direction));
        highest = std::max(highest, point.dot(direction));
      }
      return highest - lowest;
    }

    double diameter(const std::vector<Vector2> &points)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          largest = std::max(largest, (points[i] - points[j]).norm());
      return largest;
    }
  } // namespace

  double contact_depth(const BodyDescription &body, const BodyMesh &mesh,
                       const dealii::types::boundary_id side)
  {
    if (body.contact_depth)
      return body.placement.length_to_world(*body.contact_depth);
    if (const ShapeEntry &shape = shape_of(body); shape.contact_depth != nullptr)
      return body.placement.length_to_world(shape.contact_depth(body));
    constexpr double vanishing = 1e-6; // mean of a unit vector: 0 around a closed curve up to rounding
    const auto vertices = boundary_vertices(mesh);
    const Vector2 normal = mean_normal(mesh, side);
    const double depth =
        normal.norm() > vanishing ? extent(vertices, normal.normalized()) : 0.5 * diameter(vertices);
    Assert(depth > 0., dealii::ExcMessage("a body has a depth"));
    return depth;
  }
} // namespace abut
