// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/trace/normal_weight.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// So small that beside a curvature nothing of it is left, to the last digit: a flat side's normal that
    /// was off by a billionth gave a disc on it a sideways load, which pushed it as far as it could go.
    constexpr double epsilon = 1e-30;
    constexpr double straight = 1e-6;  // turning of a segment (radians) that is rounding of a mesh file
    constexpr double far_away = 1e6;   // lengths of the side, where it has no corner
    constexpr double very_near = 1e-3; // of a segment

    double noticed_turning(const Vector2 &from, const Vector2 &to)
    {
      const double angle = turning(from, to);
      return std::abs(angle) < straight ? 0. : angle;
    }
  } // namespace

  NormalWeight::NormalWeight(const Trace &side, const double longest_reach)
      : side_(side), curvatures_(side.segments().size())
  {
    Assert(longest_reach > 0., dealii::ExcMessage("a corner reaches along its side"));
    measure_curvature();
    find_corners(longest_reach);
  }

  void NormalWeight::measure_curvature()
  {
    const std::vector<Segment> &segments = side_.segments();
    std::vector<double> turnings;
    for (const Segment &segment : segments)
    {
      turnings.push_back(noticed_turning(segment.end_normals[0], segment.end_normals[1]));
      curvatures_[turnings.size() - 1].fill(turnings.back() / segment.length);
    }
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (side_.is_smooth_after(i))
      {
        const std::size_t next = *side_.following(i);
        curvatures_[i][1] = curvatures_[next][0] =
            (turnings[i] + turnings[next]) / (segments[i].length + segments[next].length);
      }
  }

  void NormalWeight::find_corners(const double longest_reach)
  {
    const std::vector<Segment> &segments = side_.segments();
    const auto mark = [&](const std::size_t segment, const std::size_t end) {
      const Segment &at = segments[segment];
      corners_.push_back(
          {at.arc_start + static_cast<double>(end) * at.length, std::min(at.length, longest_reach)});
    };
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const auto next = side_.following(i);
      if (!next && !side_.is_plane_of_symmetry(segments[i], 1))
        mark(i, 1);
      if (!side_.preceding(i) && !side_.is_plane_of_symmetry(segments[i], 0))
        mark(i, 0);
      if (next && !side_.is_smooth_after(i) &&
          noticed_turning(segments[i].end_normals[1], segments[*next].end_normals[0]) > 0.)
      {
        mark(i, 1);
        mark(*next, 0);
      }
    }
  }

  double NormalWeight::at(const std::size_t segment, const double s) const
  {
    AssertIndexRange(segment, curvatures_.size());
    const Segment &at = side_.segments()[segment];
    const double arc_length = at.arc_start + s * at.length;
    double distance = far_away * side_.length(), concentrated = 0.;
    for (const Corner &corner : corners_)
    {
      const double from_corner = std::abs(arc_length - corner.arc_length);
      distance = std::min(distance, from_corner);
      concentrated = std::max(concentrated, (1. - from_corner / corner.reach) / corner.reach);
    }
    const double curvature = (1. - s) * curvatures_[segment][0] + s * curvatures_[segment][1];
    return std::max(0., curvature) + concentrated + epsilon / std::max(distance, very_near * at.length);
  }
} // namespace abut
