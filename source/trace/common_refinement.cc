// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/common_refinement.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace abut
{
  namespace
  {
    constexpr double snap = 1e-9; // of a segment: cuts nearer to its ends, or to each other, are no cuts

    double cross(const Vector2 &a, const Vector2 &b)
    {
      return a.x() * b.y() - a.y() * b.x();
    }

    /// The place on a slave segment whose normal line passes through `point`.
    std::optional<double> place_on_slave(const Trace &slave, const Segment &segment, const Vector2 &point)
    {
      const double at_start = cross(point - segment.points.front(), segment.end_normals[0]);
      const double at_end = cross(point - segment.points.back(), segment.end_normals[1]);
      if (!(at_start * at_end < 0.))
        return {};
      const auto offset = [&](const double s) {
        return cross(point - slave.point(segment, s), Trace::averaged_normal(segment, s));
      };
      std::uintmax_t most_steps = 50;
      const auto [low, high] = boost::math::tools::toms748_solve(
          offset, 0., 1., at_start, at_end, boost::math::tools::eps_tolerance<double>(51), most_steps);
      return .5 * (low + high);
    }

    /// Master segments met by the normal line through a slave point, the nearest that faces it.
    std::optional<std::size_t> opposite(const Trace &master, const Vector2 &point, const Vector2 &normal)
    {
      std::optional<std::size_t> nearest;
      double smallest = std::numeric_limits<double>::max();
      for (std::size_t i = 0; i < master.segments().size(); ++i)
      {
        const Segment &segment = master.segments()[i];
        const double at_start = cross(segment.points.front() - point, normal);
        const double at_end = cross(segment.points.back() - point, normal);
        // With the master's body on its left, it faces the slave when it runs across the normal from left to
        // right.
        if (!(at_start <= 0. && at_end > 0.))
          continue;
        const double gap = std::abs(project(master, segment, point, normal).gap);
        if (gap < smallest)
        {
          smallest = gap;
          nearest = i;
        }
      }
      return nearest;
    }

    std::vector<double> cuts(const Trace &slave, const Segment &segment, const Trace &master)
    {
      std::vector<double> places = {0., 1.};
      const auto add = [&](const Vector2 &vertex) {
        const auto s = place_on_slave(slave, segment, vertex);
        if (s && *s > snap && *s < 1. - snap)
          places.push_back(*s);
      };
      for (const Segment &other : master.segments())
      {
        add(other.points.front());
        add(other.points.back());
      }
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end(),
                               [](const double a, const double b) { return b - a < snap; }),
                   places.end());
      places.back() = 1.;
      return places;
    }
  } // namespace

  Projection project(const Trace &master, const Segment &segment, const Vector2 &point, const Vector2 &normal)
  {
    const double at_start = cross(segment.points.front() - point, normal);
    const double at_end = cross(segment.points.back() - point, normal);
    double t = at_start / (at_start - at_end);
    for (unsigned int i = 0; segment.points.size() > 2 && i < 20; ++i)
    {
      const double step =
          cross(master.point(segment, t) - point, normal) / cross(master.tangent(segment, t), normal);
      t -= step;
      if (std::abs(step) < 1e-15)
        break;
    }
    return {t, (master.point(segment, t) - point).dot(normal)};
  }

  std::vector<Piece> common_refinement(const Trace &slave, const Trace &master)
  {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < slave.segments().size(); ++i)
    {
      const Segment &segment = slave.segments()[i];
      const std::vector<double> places = cuts(slave, segment, master);
      for (std::size_t k = 0; k + 1 < places.size(); ++k)
      {
        const double middle = .5 * (places[k] + places[k + 1]);
        const auto j =
            opposite(master, slave.point(segment, middle), Trace::averaged_normal(segment, middle));
        if (j)
          pieces.push_back({i, *j, places[k], places[k + 1]});
      }
    }
    return pieces;
  }
} // namespace abut
