// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/holomorphic_series.h>
#include <abut/bem/interior_stress.h>

#include <vector>

namespace abut
{
  /**
   * InteriorStress at very many points, in a time that grows like points plus elements: the fast multipole
   * method [GreengardRokhlin1987]. With w = zeta - z, the places zeta of a cluster of elements around c,
   *
   *   A = int q/w ds,   B = int p/w ds - int conj(zeta - c) q/w^2 ds
   *
   * are holomorphic, and the sums of InteriorStress are A and B + conj(z - c) A'. What clusters far from
   * points contribute is expanded in powers, what lies near is integrated as in InteriorStress.
   */
  class FastStress
  {
  public:
    /// `tolerance`: the error of what the elements of a cluster contribute, relative to the largest density
    /// on them. Throws std::invalid_argument as InteriorStress does.
    FastStress(const std::vector<BoundaryElement> &elements, const BoundaryValues &values,
               double shear_modulus, double poisson_ratio, double tolerance);

    /// The same to the last bit on any number of threads.
    std::vector<Stress> at(const std::vector<Complex> &points) const;

  private:
    /// Which points a call is about; their sums.
    struct Targets;

    void collect(const std::vector<BoundaryElement> &elements, const std::vector<StressDensity> &densities);
    HolomorphicSeries outgoing(const BoundaryElement &element, const StressDensity &density,
                               const Disc &disc) const;
    /// A cluster of points, with what came in so far and the clusters of elements that did not yet.
    void descend(Targets &targets, std::size_t cluster, HolomorphicSeries incoming,
                 const std::vector<std::size_t> &sources) const;
    void add_incoming(Targets &targets, std::size_t cluster, const HolomorphicSeries &incoming) const;
    void add_near(Targets &targets, std::size_t cluster, const std::vector<std::size_t> &sources) const;

    double poisson_ratio_;
    StressRules rules_;
    SeriesTranslation translation_;
    LegendreRule moments_rule_;
    ClusterTree tree_;
    std::vector<HolomorphicSeries> outgoing_; ///< of every cluster
    std::vector<StressGroup> groups_;
    std::vector<std::size_t> group_of_; ///< of every leaf
  };
} // namespace abut
