// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/partition.h>

#include <optional>
#include <vector>

namespace abut
{
  /**
   * The estimated error of the pressures that are reported along a surface, from these pressures alone. Where
   * contact ends within a stretch its exact pressure p is like a square root [Johnson1985, ch. 4 and 5], so
   * that p^2 is smooth up to there. Two parts:
   *
   * - roughness: what p at a part's place differs by from the cubic through p^2 at the two places on either
   * side;
   * - ends: p = K sqrt(s) that ends elsewhere by delta, a share of the longest part there,
   *   (K delta/2)^2 (1 + log(4 l/delta)), l the length in contact.
   *
   * Calibrated, no bound: see convergence_contact, PressureErrors.
   */
  struct PressureError
  {
    /// Where contact ends between two parts.
    struct End
    {
      std::size_t part; ///< the last that presses
      double arc;       ///< along the surface, about
      double square;
    };

    Eigen::VectorXd of_parts; ///< squares of the L2 norm: roughness
    std::vector<End> ends;
    /// Parts next to a place where the pressure rises towards the end of a stretch, as under the edge of a
    /// punch: it is infinite there, and no mesh makes its error small.
    std::vector<bool> is_singular;
  };

  /// Of the reported pressures at the places of the parts, and their loads p_k >= 0.
  PressureError pressure_error(const Partition &partition, const Eigen::VectorXd &loads,
                               const Eigen::VectorXd &pressures);
} // namespace abut
