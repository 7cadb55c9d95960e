// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/galerkin_rule.h>
#include <abut/bem/pair_integrals.h>

#include <array>
#include <vector>

namespace abut
{
  /// Integrals of an element with many others that lie apart from it, by Gauss points on both.
  class FarPairs
  {
  public:
    FarPairs(const GalerkinRule &rule, unsigned int degree);

    /// The index of FarPoints for an element of this length, -1 where the distance is too short.
    int tier(double distance, double length) const;
    unsigned int n_tiers() const { return static_cast<unsigned int>(rules_.size()); }

    /// Integrates x over `first`, y over every one of `seconds`, with the points of the tiers.
    void integrate(const BoundaryElement &first, const std::vector<const BoundaryElement *> &seconds,
                   unsigned int first_tier, unsigned int second_tier);
    /// What the last call found for seconds[k].
    void copy(std::size_t k, PairIntegrals &integrals) const;

  private:
    /// ln |w|, conj(w)/w, and Im(direction/w) with the direction of the second and of the first.
    static constexpr unsigned int n_kernels = 5;

    void place(const BoundaryElement &first, const std::vector<const BoundaryElement *> &seconds,
               const LegendreRule &rule);
    void evaluate(const BoundaryElement &first, const LegendreRule &rule);
    void sum(const LegendreRule &first_rule, const LegendreRule &second_rule);

    unsigned int degree_;
    std::vector<double> distances_;
    std::vector<LegendreRule> rules_;
    // A row for every second element and point of the first; the second's number runs fastest.
    Eigen::ArrayXd offset_x_, offset_y_;            // from the point of the first to the centre of the second
    Eigen::ArrayXd half_x_, half_y_;                // half of the second
    Eigen::ArrayXd scale_;                          // quarter product of the lengths, one for every second
    std::array<Eigen::ArrayXXd, n_kernels> values_; // a column for every point of the second
    std::array<Eigen::MatrixXd, n_kernels> integrals_; // a row for every second, a column for every i, j
  };
} // namespace abut
