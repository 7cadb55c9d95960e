// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <cmath>
#include <functional>

namespace abut
{
  using Place = std::function<Vector2(double)>;

  /// A curve without a mesh: a segment between any two neighbouring parameters, its unknowns numbered along
  /// it.
  inline Trace make_curve(const Place &place, const std::vector<double> &parameters,
                          const unsigned int degree, const unsigned int geometry_degree,
                          const bool closed = false)
  {
    const LagrangeBasis geometry(geometry_degree);
    const auto n_segments = static_cast<unsigned int>(parameters.size()) - 1;
    const unsigned int n_nodes = n_segments * degree + (closed ? 0 : 1);
    std::vector<Segment> segments(n_segments);
    for (unsigned int i = 0; i < n_segments; ++i)
    {
      for (const double s : geometry.nodes())
        segments[i].points.push_back(place((1. - s) * parameters[i] + s * parameters[i + 1]));
      for (unsigned int k = 0; k <= degree; ++k)
        segments[i].nodes.push_back((i * degree + k) % n_nodes);
    }
    std::vector<std::array<unsigned int, 2>> dofs;
    for (unsigned int node = 0; node < n_nodes; ++node)
      dofs.push_back({{2 * node, 2 * node + 1}});
    return Trace(degree, geometry_degree, std::move(segments), std::move(dofs));
  }

  /// n + 1 parameters from `first` to `last`, equally far apart.
  inline std::vector<double> parameters(const double first, const double last, const unsigned int n)
  {
    std::vector<double> result;
    for (unsigned int i = 0; i <= n; ++i)
      result.push_back(((n - i) * first + i * last) / n);
    return result;
  }

  /// From (x0, y) to (x1, y) in n segments; x1 < x0: the body lies below.
  inline Trace make_line(const double x0, const double x1, const double y, const unsigned int n,
                         const unsigned int degree = 1)
  {
    return make_curve([y](const double x) { return Vector2(x, y); }, parameters(x0, x1, n), degree, 1);
  }

  /// The arc around the origin between two angles, with the body inside for growing angles.
  inline Trace make_arc(const double radius, const double from, const double to, const unsigned int n,
                        const unsigned int degree, const unsigned int geometry_degree = 4)
  {
    return make_curve(
        [radius](const double angle) { return Vector2(radius * std::cos(angle), radius * std::sin(angle)); },
        parameters(from, to, n), degree, geometry_degree, std::abs(std::abs(to - from) - 2. * M_PI) < 1e-12);
  }
} // namespace abut
