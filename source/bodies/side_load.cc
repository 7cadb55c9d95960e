// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/side_load.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

  namespace
  {
    /// By the rule on an interval of a segment.
    Eigen::MatrixX2d moments_by_rule(const Trace &side, const Segment &segment, const SideTraction &traction,
                                     const double from, const double to)
    {
      static const GaussRule rule = GaussRule::for_singular_ends(18);
      Eigen::MatrixX2d moments = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(segment.nodes.size()), 2);
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double s = from + (to - from) * rule.points[q];
        const Vector2 tangent = side.tangent(segment, s);
        moments += (to - from) * rule.weights[q] * tangent.norm() * side.basis().values(s) *
                   traction(side.point(segment, s), outward_normal(tangent)).transpose();
      }
      return moments;
    }

    /// The same, halved until that changes no more: tractions may jump or be narrow.
    Eigen::MatrixX2d halved_moments(const Trace &side, const Segment &segment, const SideTraction &traction,
                                    const double from, const double to, const Eigen::MatrixX2d &whole,
                                    const double size)
    {
      constexpr double accuracy = 1e-9, shortest = 1e-6;
      const double middle = .5 * (from + to);
      const Eigen::MatrixX2d first = moments_by_rule(side, segment, traction, from, middle),
                             second = moments_by_rule(side, segment, traction, middle, to);
      const double largest = std::max({size, first.norm(), second.norm()});
      if ((first + second - whole).norm() <= accuracy * largest || to - from < shortest)
        return whole;
      return halved_moments(side, segment, traction, from, middle, first, largest) +
             halved_moments(side, segment, traction, middle, to, second, largest);
    }
  } // namespace

  unsigned int n_sampled_pieces(const Trace &side, const Segment &segment)
  {
    constexpr double of_side = 128.;
    return static_cast<unsigned int>(std::ceil(of_side * segment.length / side.length()));
  }

  Eigen::MatrixX2d traction_moments(const Trace &side, const Segment &segment, const SideTraction &traction,
                                    const unsigned int n_pieces)
  {
    std::vector<Eigen::MatrixX2d> pieces;
    double size = 0.;
    const auto end = [&](const unsigned int piece) { return piece / static_cast<double>(n_pieces); };
    for (unsigned int piece = 0; piece < n_pieces; ++piece)
    {
      pieces.push_back(moments_by_rule(side, segment, traction, end(piece), end(piece + 1)));
      size = std::max(size, pieces.back().norm());
    }
    Eigen::MatrixX2d sum = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(segment.nodes.size()), 2);
    for (unsigned int piece = 0; piece < n_pieces; ++piece)
      sum += halved_moments(side, segment, traction, end(piece), end(piece + 1), pieces[piece], size);
    return sum;
  }

  void add_traction(const Trace &side, const Condition &condition, const Placement &placement,
                    Eigen::VectorXd &load)
  {
    const bool is_sampled = varies(condition);
    for (const Segment &segment : side.segments())
    {
      const Eigen::MatrixX2d moments = traction_moments(
          side, segment,
          [&](const Vector2 &point, const Vector2 &normal) {
            return prescribed_traction(condition, placement, point, normal);
          },
          is_sampled ? n_sampled_pieces(side, segment) : 1);
      for (std::size_t i = 0; i < segment.nodes.size(); ++i)
        for (unsigned int component = 0; component < 2; ++component)
          load[side.node_dofs()[segment.nodes[i]][component]] +=
              moments(static_cast<Eigen::Index>(i), component);
    }
  }
} // namespace abut
