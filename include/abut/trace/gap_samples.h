// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/mortar_coupling.h>

namespace abut
{
  /**
   * The gap between two curves as it is at single points, where MortarCoupling has weighted means: on every
   * piece of the common refinement at its ends and at three points between. With trace displacements u the
   * gaps are gap + slave u_s + master u_m, along the averaged slave normal, positive where the bodies are
   * apart.
   */
  struct GapSamples
  {
    Eigen::SparseMatrix<double, Eigen::RowMajor> slave;  ///< samples x slave trace components
    Eigen::SparseMatrix<double, Eigen::RowMajor> master; ///< samples x master trace components
    Eigen::VectorXd gap;                                 ///< initial
    std::vector<Piece> pieces;                           ///< where each sample lies
  };

  GapSamples sample_gaps(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                         const GapFunction &gap);
} // namespace abut
