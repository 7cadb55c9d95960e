// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/trace/trace.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace abut
{
  namespace
  {
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
    check_segments();
    measure();
    average_normals();
    place_nodes();
  }

  void Trace::serialize(Archive &archive)
  {
    unsigned int degree = basis_.degree(), geometry_degree = geometry_.degree();
    archive(degree, geometry_degree, segments_, node_dofs_, supports_);
    if (!archive.unpacks())
      return;
    std::vector<Eigen::Matrix2d> supports = std::move(supports_);
    *this = Trace(degree, geometry_degree, std::move(segments_), std::move(node_dofs_));
    if (!supports.empty())
      set_supports(std::move(supports));
  }

  void Trace::check_segments() const
  {
    for ([[maybe_unused]] const Segment &segment : segments_)
    {
      AssertDimension(segment.nodes.size(), basis_.degree() + 1);
      AssertDimension(segment.points.size(), geometry_.degree() + 1);
      Assert(std::all_of(segment.nodes.begin(), segment.nodes.end(),
                         [&](const unsigned int node) { return node < n_nodes(); }),
             dealii::ExcMessage("the nodes of a segment are those of its trace"));
      Assert(std::all_of(segment.points.begin(), segment.points.end(),
                         [](const Vector2 &point) { return point.allFinite(); }),
             dealii::ExcMessage("places are numbers"));
    }
  }

  bool Trace::is_smooth_after(const std::size_t segment) const
  {
    AssertIndexRange(segment, segments_.size());
    return following_[segment] && corner_normals_.count(segments_[segment].nodes.back()) == 0;
  }

  void Trace::set_supports(std::vector<Eigen::Matrix2d> projections)
  {
    AssertDimension(projections.size(), n_nodes());
    for ([[maybe_unused]] const Eigen::Matrix2d &projection : projections)
      Assert((projection - projection.transpose()).norm() < 1e-12,
             dealii::ExcMessage("a projection on directions is symmetric"));
    supports_ = std::move(projections);
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (const std::size_t end : {std::size_t(0), std::size_t(1)})
      {
        const bool is_free = !(end == 0 ? preceding_[i] : following_[i]);
        if (!is_free || !is_plane_of_symmetry(segments_[i], end))
          continue;
        Vector2 &normal = segments_[i].end_normals[end];
        const Vector2 mirrored = normal - support_at(segments_[i], end) * normal;
        if (mirrored.squaredNorm() > .5)
          normal = mirrored.normalized();
      }
  }

  Eigen::Matrix2d Trace::support_at(const Segment &segment, const std::size_t end) const
  {
    if (supports_.empty())
      return Eigen::Matrix2d::Zero();
    return supports_[end == 0 ? segment.nodes.front() : segment.nodes.back()];
  }

  bool Trace::is_plane_of_symmetry(const Segment &segment, const std::size_t end) const
  {
    AssertIndexRange(end, 2);
    const Eigen::Matrix2d support = support_at(segment, end);
    const Vector2 along = tangent(segment, static_cast<double>(end)).normalized();
    return (support * along).squaredNorm() > .5 && support.trace() < 1.5; // one direction
  }

  bool Trace::is_held(const Segment &segment, const double s, const Vector2 &direction) const
  {
    Assert(std::abs(direction.norm() - 1.) < 1e-8, dealii::ExcMessage("directions have unit length"));
    constexpr double round_off = 1e-9;
    if (supports_.empty())
      return false;
    const Eigen::VectorXd values = basis_.values(s);
    for (std::size_t i = 0; i < segment.nodes.size(); ++i)
      if (std::abs(values[static_cast<Eigen::Index>(i)]) > round_off &&
          (direction - supports_[segment.nodes[i]] * direction).norm() > round_off)
        return false;
    return true;
  }

  Vector2 Trace::point(const Segment &segment, const double s) const
  {
    if (segment.points.size() == 2)
      return (1. - s) * segment.points[0] + s * segment.points[1];
    return combine(geometry_.values(s), segment.points);
  }

  Vector2 Trace::tangent(const Segment &segment, const double s) const
  {
    if (segment.points.size() == 2)
      return segment.points[1] - segment.points[0];
    return combine(geometry_.derivatives(s), segment.points);
  }

  Vector2 Trace::displacement(const Segment &segment, const double s, const Eigen::VectorXd &of_body) const
  {
    const Eigen::VectorXd values = basis_.values(s);
    Vector2 sum = Vector2::Zero();
    for (std::size_t i = 0; i < segment.nodes.size(); ++i)
    {
      const auto &dofs = node_dofs_[segment.nodes[i]];
      sum += values[static_cast<Eigen::Index>(i)] * Vector2(of_body[dofs[0]], of_body[dofs[1]]);
    }
    return sum;
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
      segment.end_normals = {{outward_normal(tangent(segment, 0.)), outward_normal(tangent(segment, 1.))}};
    }
  }

  void Trace::average_normals()
  {
    following_.resize(segments_.size());
    preceding_.resize(segments_.size());
    std::vector<std::optional<std::size_t>> starting_at(n_nodes());
    for (std::size_t i = 0; i < segments_.size(); ++i)
      starting_at[segments_[i].nodes.front()] = i;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (const auto next = starting_at[segments_[i].nodes.back()])
      {
        following_[i] = next;
        preceding_[*next] = i;
        Vector2 &here = segments_[i].end_normals[1], &there = segments_[*next].end_normals[0];
        if (is_smooth(here, there))
          here = there = (here + there).normalized();
        else
          corner_normals_[segments_[i].nodes.back()] = {{here, there}};
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
        node_normals_[node] += is_end ? averaged_normal(*segment, s) : outward_normal(tangent(*segment, s));
        node_arc_lengths_[node] = segment->arc_start + s * segment->length;
      }
    for (Vector2 &normal : node_normals_)
      normal.normalize();
  }

  std::vector<Vector2> Trace::normals_at(const std::size_t node) const
  {
    AssertIndexRange(node, n_nodes());
    const auto corner = corner_normals_.find(node);
    if (corner == corner_normals_.end())
      return {node_normals_[node]};
    return {corner->second[0], corner->second[1]};
  }
} // namespace abut
