// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/polygon_area.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace abut
{
  namespace
  {
    std::vector<Vector2> ends_of(const std::vector<PolygonArea::Edge> &edges)
    {
      std::vector<Vector2> points;
      for (const PolygonArea::Edge &edge : edges)
        points.insert(points.end(), edge.begin(), edge.end());
      return points;
    }

    double distance_to(const PolygonArea::Edge &edge, const Vector2 &point)
    {
      const Vector2 along = edge[1] - edge[0];
      const double square = along.squaredNorm();
      const double share = square > 0. ? std::clamp(along.dot(point - edge[0]) / square, 0., 1.) : 0.;
      return (edge[0] + share * along - point).norm();
    }
  } // namespace

  PolygonArea::PolygonArea(std::vector<Edge> edges)
      : edges_(std::move(edges)), box_(box_around(ends_of(edges_)))
  {
    // As many cells as edges, about square.
    const Vector2 extent = box_.high - box_.low;
    const double n = static_cast<double>(edges_.size());
    width_ = std::max(std::sqrt(extent.x() * extent.y() / n), extent.maxCoeff() / n);
    if (!(width_ > 0.))
      width_ = 1.;
    for (const int i : {0, 1})
      size_[static_cast<std::size_t>(i)] = static_cast<int>(extent[i] / width_) + 1;
    grid_.resize(static_cast<std::size_t>(size_[0] * size_[1]));
    for (std::size_t k = 0; k < edges_.size(); ++k)
    {
      const Cell low = cell_at(edges_[k][0].cwiseMin(edges_[k][1])),
                 high = cell_at(edges_[k][0].cwiseMax(edges_[k][1]));
      for (int column = low[0]; column <= high[0]; ++column)
        for (int row = low[1]; row <= high[1]; ++row)
          grid_[static_cast<std::size_t>(column * size_[1] + row)].push_back(k);
    }
  }

  PolygonArea::Cell PolygonArea::cell_at(const Vector2 &point) const
  {
    const auto index = [&](const int i) {
      const double share = (point[i] - box_.low[i]) / width_;
      return static_cast<int>(std::clamp(share, 0., size_[static_cast<std::size_t>(i)] - 1.));
    };
    return {{index(0), index(1)}};
  }

  bool PolygonArea::contains(const Vector2 &point) const
  {
    if ((point.array() < box_.low.array()).any() || (point.array() > box_.high.array()).any())
      return false;
    const Cell start = cell_at(point);
    bool inside = false;
    for (int row = start[1]; row < size_[1]; ++row)
      for (const std::size_t k : edges_in({{start[0], row}}))
      {
        const auto &[from, to] = edges_[k];
        if ((from.x() <= point.x()) == (to.x() <= point.x()))
          continue;
        const double share = (point.x() - from.x()) / (to.x() - from.x()),
                     y = std::clamp(from.y() + share * (to.y() - from.y()), std::min(from.y(), to.y()),
                                    std::max(from.y(), to.y()));
        // An edge stands in several cells: it counts in that where it is met.
        if (y > point.y() && cell_at({point.x(), y})[1] == row)
          inside = !inside;
      }
    return inside;
  }

  void PolygonArea::look_in_ring(const Cell &centre, const int ring, const Vector2 &point,
                                 const std::function<bool(std::size_t)> &counts,
                                 std::optional<Nearest> &best) const
  {
    for (int column = std::max(0, centre[0] - ring); column <= std::min(size_[0] - 1, centre[0] + ring);
         ++column)
    {
      const bool whole = std::abs(column - centre[0]) == ring;
      for (int row = centre[1] - ring; row <= centre[1] + ring; row += whole || ring == 0 ? 1 : 2 * ring)
      {
        if (row < 0 || row >= size_[1])
          continue;
        for (const std::size_t k : edges_in({{column, row}}))
          if (counts(k))
            if (const double distance = distance_to(edges_[k], point); !best || distance < best->distance)
              best = Nearest{k, distance};
      }
    }
  }

  std::optional<PolygonArea::Nearest>
  PolygonArea::nearest(const Vector2 &point, const std::function<bool(std::size_t)> &counts) const
  {
    const Cell centre = cell_at(point);
    std::optional<Nearest> best;
    for (int ring = 0; ring < std::max(size_[0], size_[1]); ++ring)
    {
      if (best && best->distance <= (ring - 1) * width_)
        break;
      look_in_ring(centre, ring, point, counts, best);
    }
    return best;
  }

  std::vector<double> PolygonArea::crossings(const Edge &line) const
  {
    const Cell low = cell_at(line[0].cwiseMin(line[1])), high = cell_at(line[0].cwiseMax(line[1]));
    const Vector2 along = line[1] - line[0];
    std::set<std::size_t> met;
    std::vector<double> shares;
    for (int column = low[0]; column <= high[0]; ++column)
      for (int row = low[1]; row <= high[1]; ++row)
        for (const std::size_t k : edges_in({{column, row}}))
        {
          const auto &[from, to] = edges_[k];
          const double left_of_start = cross(along, from - line[0]), left_of_end = cross(along, to - line[0]);
          if ((left_of_start > 0.) == (left_of_end > 0.) || !met.insert(k).second)
            continue;
          const Vector2 place = from + left_of_start / (left_of_start - left_of_end) * (to - from);
          const double share = along.dot(place - line[0]) / along.squaredNorm();
          if (share >= 0. && share <= 1.)
            shares.push_back(share);
        }
    std::sort(shares.begin(), shares.end());
    return shares;
  }
} // namespace abut
