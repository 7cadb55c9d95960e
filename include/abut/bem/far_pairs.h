// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/pair_integrals.h>

#include <array>
#include <vector>

namespace abut
{
  /// Integrals of an element with a few others that lie apart from it, by Gauss points on both.
  class FarPairs
  {
  public:
    /// So many others are integrated at once, one in every lane of the processor's vectors.
    static constexpr std::size_t n_lanes = 8;
    using Lanes = std::array<double, n_lanes>;
    using Partners = std::array<const BoundaryElement *, n_lanes>;
    /// 2 ln |w|, real and imaginary part of conj(w)/w, Im(direction/w) of the second and of the first.
    static constexpr std::size_t n_kernels = 5;
    using Kernels = std::array<double, n_kernels * n_lanes>;
    using Integrals = std::array<std::array<Kernels, max_density_degree + 1>, max_density_degree + 1>;

    struct Seconds
    {
      Lanes x, y;           // centre as seen from the centre of the first
      Lanes half_x, half_y; // half of the element
      Lanes direction_x, direction_y;
    };

    FarPairs(const GalerkinRule &rule, unsigned int degree);

    /// The index of FarPoints for an element of this length, -1 where the distance is too short.
    int tier(const double distance, const double length) const
    {
      int index = -1;
      while (index + 1 < n_distances_ &&
             distance >= beside_ties * distances_[static_cast<std::size_t>(index + 1)] * length)
        ++index;
      return index;
    }
    std::size_t n_tiers() const { return rules_.size(); }

    /// x on `first`, y on every one of `seconds`, with the points of the tiers.
    void integrate(const BoundaryElement &first, const Partners &seconds, std::size_t first_tier,
                   std::size_t second_tier);
    /// What the last call found for one of them.
    void copy(std::size_t lane, PairIntegrals &integrals) const;

  private:
    void set_seconds(const BoundaryElement &first, const Partners &seconds);

    unsigned int degree_;
    int n_distances_;
    std::vector<double> distances_;
    std::vector<LegendreRule> rules_;
    Seconds seconds_;
    Lanes scale_; // quarter product of the lengths
    Integrals integrals_;
  };
} // namespace abut
