// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/far_pairs.h>
#include <abut/bem/near_pairs.h>

#include <functional>
#include <vector>

namespace abut
{
  /// Integrals of pairs of elements, near or far, by a rule.
  class PairIntegrator
  {
  public:
    using Visitor =
        std::function<void(std::size_t first, std::size_t second, const PairIntegrals &integrals)>;

    /// The elements must outlive the object.
    PairIntegrator(const std::vector<BoundaryElement> &elements, unsigned int degree,
                   const GalerkinRule &rule);

    /// The pairs of `element` with first ... end - 1, in any order; of either order one is visited.
    void integrate(std::size_t element, std::size_t first, std::size_t end, const Visitor &visit);

  private:
    /// Puts `other` into one of the element's queues if both are far from each other.
    bool queue_far(std::size_t element, std::size_t other, const Visitor &visit);
    void integrate_near(std::size_t element, std::size_t other, const Visitor &visit) const;
    /// Empties a queue; lanes to spare repeat its last element.
    void integrate_far(std::size_t element, std::size_t tiers, const Visitor &visit);

    const std::vector<BoundaryElement> &elements_;
    unsigned int degree_;
    NearPairs near_;
    FarPairs far_;
    std::vector<std::vector<std::size_t>> queues_; ///< far from one element, by both tiers
    PairIntegrals integrals_;
    double round_off_;
  };
} // namespace abut
