// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/side_load.h>

namespace abut
{
  Vector2 prescribed_traction(const Condition &condition, const Placement &placement, const Vector2 &point,
                              const Vector2 &normal)
  {
    const Vector2 own = placement.point_to_own(point);
    if (condition.kind == ConditionKind::pressure)
      return -condition.expressions[0](own) * normal;
    return placement.direction_to_world(
        Vector2(condition.expressions[0](own), condition.expressions[1](own)));
  }

  Eigen::MatrixX2d traction_moments(const Trace &side, const Segment &segment, const SideTraction &traction)
  {
    const GaussRule rule = GaussRule::for_singular_ends(18);
    Eigen::MatrixX2d moments = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(segment.nodes.size()), 2);
    for (Eigen::Index q = 0; q < rule.points.size(); ++q)
    {
      const double s = rule.points[q];
      const Vector2 tangent = side.tangent(segment, s);
      const Vector2 normal = outward_normal(tangent);
      moments += rule.weights[q] * tangent.norm() * side.basis().values(s) *
                 traction(side.point(segment, s), normal).transpose();
    }
    return moments;
  }

  void add_traction(const Trace &side, const Condition &condition, const Placement &placement,
                    Eigen::VectorXd &load)
  {
    for (const Segment &segment : side.segments())
    {
      const Eigen::MatrixX2d moments =
          traction_moments(side, segment, [&](const Vector2 &point, const Vector2 &normal) {
            return prescribed_traction(condition, placement, point, normal);
          });
      for (std::size_t i = 0; i < segment.nodes.size(); ++i)
        for (unsigned int component = 0; component < 2; ++component)
          load[side.node_dofs()[segment.nodes[i]][component]] +=
              moments(static_cast<Eigen::Index>(i), component);
    }
  }
} // namespace abut
