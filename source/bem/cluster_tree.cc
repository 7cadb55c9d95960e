// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/cluster_tree.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut
{
  namespace
  {
    struct ClusterBox
    {
      Complex low, high;

      Complex centre() const { return .5 * (low + high); }
      bool is_wide() const { return (high - low).real() >= (high - low).imag(); }
      bool is_point() const { return low == high; }
    };

    template <typename Iterator>
    ClusterBox box_around(const std::vector<Disc> &members, const Iterator first, const Iterator last)
    {
      Complex low = members[*first].centre, high = low;
      for (Iterator member = first; member != last; ++member)
      {
        const Complex z = members[*member].centre;
        low = {std::min(low.real(), z.real()), std::min(low.imag(), z.imag())};
        high = {std::max(high.real(), z.real()), std::max(high.imag(), z.imag())};
      }
      return {low, high};
    }
  } // namespace

  ClusterTree::ClusterTree(const std::vector<Disc> &members, const std::size_t leaf_size)
      : order_(members.size())
  {
    Assert(!members.empty() && leaf_size > 0, dealii::ExcMessage("there is something to divide"));
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    clusters_.push_back({0, members.size(), {}, 0});
    for (std::size_t i = 0; i < clusters_.size(); ++i)
    {
      Cluster cluster = clusters_[i];
      const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(cluster.first),
                 end = order_.begin() + static_cast<std::ptrdiff_t>(cluster.last);
      const ClusterBox box = box_around(members, begin, end);
      cluster.disc.centre = box.centre();
      for (auto member = begin; member != end; ++member)
        cluster.disc.radius = std::max(cluster.disc.radius,
                                       std::sqrt(std::norm(members[*member].centre - cluster.disc.centre)) +
                                           members[*member].radius);
      if (cluster.size() > leaf_size && !box.is_point())
      {
        const Complex middle = box.centre();
        const auto split = std::partition(begin, end, [&](const std::size_t member) {
          const Complex z = members[member].centre;
          return box.is_wide() ? z.real() <= middle.real() : z.imag() <= middle.imag();
        });
        const auto at = static_cast<std::size_t>(split - order_.begin());
        cluster.children = clusters_.size();
        clusters_.push_back({cluster.first, at, {}, 0});
        clusters_.push_back({at, cluster.last, {}, 0});
      }
      clusters_[i] = cluster;
    }
  }

  std::vector<Disc> discs_of(const std::vector<BoundaryElement> &elements)
  {
    std::vector<Disc> discs;
    discs.reserve(elements.size());
    for (const BoundaryElement &element : elements)
      discs.push_back({element.point(0.), .5 * element.length});
    return discs;
  }
} // namespace abut
