// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/mortar_coupling.h>

namespace abut
{
  /**
   * The gap between two curves as it is at single points, where MortarCoupling has weighted means: at equally
   * spaced points of every piece of the common refinement, its ends included. With trace displacements u the
   * gaps are gap + slave u_s + master u_m, along the averaged slave normal, positive where the bodies are
   * apart.
   */
  struct GapSamples
  {
    static constexpr Eigen::Index per_piece = 5;

    Eigen::SparseMatrix<double, Eigen::RowMajor> slave; ///< samples, piece by piece, x slave trace components
    Eigen::SparseMatrix<double, Eigen::RowMajor> master; ///< samples x master trace components
    Eigen::VectorXd gap;                                 ///< initial
    std::vector<Piece> pieces;
  };

  /// The smallest value of the parabolas through three neighbours each among equally spaced samples: exact
  /// for quadratic functions, wherever their minimum lies between the first and the last sample.
  double smallest_value(const Eigen::VectorXd &samples);

  GapSamples sample_gaps(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                         const GapFunction &gap);
} // namespace abut
