// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/surface.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace abut
{
  namespace
  {
    constexpr double snap = 1e-11; // of a segment: cuts nearer to its ends, or to each other, are no cuts

    std::vector<double> cuts(const Surface &surface, const std::vector<CommonNormal> &normals,
                             const std::size_t side, const std::size_t segment)
    {
      std::vector<double> places = {0., 1.};
      for (std::size_t k = 0; k < surface.links.size(); ++k)
      {
        if (surface.links[k].cut != side)
          continue;
        for (const double s : normals[k].places_opposite_ends(segment))
          if (s > snap && s < 1. - snap)
            places.push_back(s);
      }
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end(),
                               [](const double a, const double b) { return b - a < snap; }),
                   places.end());
      places.back() = 1.;
      return places;
    }

    /// The link and segment that a point meets first.
    std::optional<std::pair<std::size_t, std::size_t>> first_facing(const Surface &surface,
                                                                    const std::vector<CommonNormal> &normals,
                                                                    const std::size_t side,
                                                                    const std::size_t segment, const double s)
    {
      std::optional<std::pair<std::size_t, std::size_t>> first;
      double smallest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < surface.links.size(); ++k)
      {
        if (surface.links[k].cut != side)
          continue;
        const auto facing = normals[k].facing(segment, s, surface.links[k].deepest);
        if (facing && facing->opposite.gap < smallest)
        {
          smallest = facing->opposite.gap;
          first.emplace(k, facing->segment);
        }
      }
      return first;
    }
  } // namespace

  std::vector<CommonNormal> common_normals(const Surface &surface)
  {
    std::vector<CommonNormal> normals;
    for (const SurfaceLink &link : surface.links)
    {
      AssertIndexRange(link.cut, surface.cut.size());
      AssertIndexRange(link.other, surface.others.size());
      normals.emplace_back(*surface.cut[link.cut].trace, *surface.others[link.other].trace);
    }
    return normals;
  }

  std::vector<Piece> common_refinement(const Surface &surface, const std::vector<CommonNormal> &normals)
  {
    AssertDimension(normals.size(), surface.links.size());
    std::vector<Piece> pieces;
    for (std::size_t side = 0; side < surface.cut.size(); ++side)
      for (std::size_t i = 0; i < surface.cut[side].trace->segments().size(); ++i)
      {
        const std::vector<double> places = cuts(surface, normals, side, i);
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
          if (const auto facing = first_facing(surface, normals, side, i, .5 * (places[k] + places[k + 1])))
            pieces.push_back({facing->first, i, facing->second, places[k], places[k + 1]});
      }
    return pieces;
  }

  double arc_length(const Trace &side, const Segment &segment, const double start, const double end)
  {
    Assert(start <= end, dealii::ExcMessage("an interval runs forwards"));
    if (segment.points.size() == 2)
      return (end - start) * segment.length;
    const GaussRule rule(static_cast<unsigned int>(segment.points.size()) + 1);
    double length = 0.;
    for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      length += (end - start) * rule.weights[q] *
                side.tangent(segment, start + (end - start) * rule.points[q]).norm();
    return length;
  }
} // namespace abut
