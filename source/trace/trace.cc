// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/trace.h>

#include <Eigen/Geometry>

#include <utility>

namespace abut
{
  namespace
  {
    Vector2 outward(const Vector2 &tangent)
    {
      return Vector2(tangent.y(), -tangent.x()).normalized();
    }

    Vector2 combine(const Eigen::VectorXd &coefficients, const std::vector<Vector2> &points)
    {
      Vector2 sum = Vector2::Zero();
      for (std::size_t i = 0; i < points.size(); ++i)
        sum += coefficients[static_cast<Eigen::Index>(i)] * points[i];
      return sum;
    }
  } // namespace

  Trace::Trace(const unsigned int degree, const unsigned int geometry_degree, std::vector<Segment> segments,
               std::vector<std::array<unsigned int, 2>> node_dofs)
      : basis_(degree), geometry_(geometry_degree), segments_(std::move(segments)),
        node_dofs_(std::move(node_dofs))
  {
    measure();
    average_normals();
    place_nodes();
  }

  Vector2 Trace::point(const Segment &segment, const double s) const
  {
    return combine(geometry_.values(s), segment.points);
  }

  Vector2 Trace::tangent(const Segment &segment, const double s) const
  {
    return combine(geometry_.derivatives(s), segment.points);
  }

  Vector2 Trace::averaged_normal(const Segment &segment, const double s)
  {
    return ((1. - s) * segment.end_normals[0] + s * segment.end_normals[1]).normalized();
  }

  void Trace::measure()
  {
    const GaussRule rule(geometry_.degree() + 2);
    for (Segment &segment : segments_)
    {
      segment.arc_start = length_;
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        segment.length += rule.weights[q] * tangent(segment, rule.points[q]).norm();
      length_ += segment.length;
      segment.end_normals = {{outward(tangent(segment, 0.)), outward(tangent(segment, 1.))}};
    }
  }

  void Trace::average_normals()
  {
    const double smallest_cosine = std::sqrt(.5);
    std::vector<Segment *> starting_at(n_nodes(), nullptr);
    for (Segment &segment : segments_)
      starting_at[segment.nodes.front()] = &segment;
    for (Segment &segment : segments_)
      if (Segment *const next = starting_at[segment.nodes.back()])
      {
        Vector2 &here = segment.end_normals[1], &there = next->end_normals[0];
        if (here.dot(there) > smallest_cosine)
          here = there = (here + there).normalized();
        else
          corner_normals_[segment.nodes.back()] = {{here, there}};
      }
  }

  void Trace::place_nodes()
  {
    node_points_.resize(n_nodes());
    node_normals_.assign(n_nodes(), Vector2::Zero());
    node_arc_lengths_.resize(n_nodes());
    // Backwards, so that the common node of a closed curve's ends gets arc length zero.
    for (auto segment = segments_.rbegin(); segment != segments_.rend(); ++segment)
      for (std::size_t i = segment->nodes.size(); i-- > 0;)
      {
        const double s = basis_.nodes()[static_cast<Eigen::Index>(i)];
        const unsigned int node = segment->nodes[i];
        node_points_[node] = point(*segment, s);
        const bool is_end = i == 0 || i + 1 == segment->nodes.size();
        node_normals_[node] += is_end ? averaged_normal(*segment, s) : outward(tangent(*segment, s));
        node_arc_lengths_[node] = segment->arc_start + s * segment->length;
      }
    for (Vector2 &normal : node_normals_)
      normal.normalize();
  }

  std::vector<Vector2> Trace::normals_at(const std::size_t node) const
  {
    const auto corner = corner_normals_.find(node);
    if (corner == corner_normals_.end())
      return {node_normals_[node]};
    return {corner->second[0], corner->second[1]};
  }
} // namespace abut
