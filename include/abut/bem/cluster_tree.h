// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_element.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace abut
{
  /// A disc.
  struct Disc
  {
    Complex centre = 0.;
    double radius = 0.;
  };

  /**
   * Things that lie in small discs, in clusters: a binary tree, each cluster halved across the longer side of
   * the box around the centres, until it has few members. The members of a cluster are consecutive in
   * `order()`, parents come before their children, the root is the first.
   */
  class ClusterTree
  {
  public:
    struct Cluster
    {
      std::size_t first, last; ///< members: order()[first ... last - 1]
      Disc disc;               ///< all of them lie in it
      std::size_t children;    ///< index of the first of two consecutive ones; 0: it has none

      std::size_t size() const { return last - first; }
      bool is_leaf() const { return children == 0; }
    };

    /// At least one member; leaves have at most `leaf_size`, but for discs with one centre.
    ClusterTree(const std::vector<Disc> &members, std::size_t leaf_size);

    const std::vector<Cluster> &clusters() const { return clusters_; }
    const std::vector<std::size_t> &order() const { return order_; }

  private:
    std::vector<Cluster> clusters_;
    std::vector<std::size_t> order_;
  };

  /// Around each element.
  std::vector<Disc> discs_of(const std::vector<BoundaryElement> &elements);

  /// Whether discs are so far apart that series from one into the other converge by a factor of `convergence`
  /// (below 1) from term to term, those of either side: radius <= convergence (distance - other radius).
  inline bool are_apart(const Disc &a, const Disc &b, const double convergence)
  {
    const double larger = std::max(a.radius, b.radius), smaller = std::min(a.radius, b.radius);
    return larger + convergence * smaller <= convergence * std::sqrt(std::norm(a.centre - b.centre));
  }
} // namespace abut
