// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <cmath>
#include <optional>

namespace abut
{
  /// Squared L2 norms of stress differences over some cells: estimated error, true error of the finite
  /// elements' stress, and of the better stress where there is one.
  struct ErrorSquares
  {
    double estimated = 0., computed = 0., better = 0.;

    /// ||sigma_B - sigma_F|| / ||sigma* - sigma_F||
    double effectivity() const { return std::sqrt(estimated / computed); }
    /// The C of (23): ||sigma* - sigma_B|| / ||sigma* - sigma_F||
    double better_ratio() const { return std::sqrt(better / computed); }

    void serialize(Archive &archive) { archive(estimated, computed, better); }
  };

  /**
   * What an indicator is worth where sigma*, the exact response to the traction that was applied, is known;
   * all bodies. The norms are those of the indicator: L2 over xx, yy, zz and twice xy, at its own points.
   */
  struct EstimatorQuality
  {
    ErrorSquares whole;
    ErrorSquares boundary;    ///< cells with an edge on the boundary
    ErrorSquares contact_end; ///< cells within one and a half diameters of the edge where contact ends
    ErrorSquares interior;    ///< cells without one
    bool has_better = false;  ///< the indicator has a better stress
    double pearson = 0.;      ///< correlation of estimated and true cell errors
    double spearman = 0.;     ///< and of their ranks
    double stress = 0.;       ///< squared L2 norm of sigma*

    void serialize(Archive &archive)
    {
      archive(whole, boundary, contact_end, interior, has_better, pearson, spearman, stress);
    }
  };
} // namespace abut
