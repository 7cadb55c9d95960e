// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/common_refinement.h>

#include <Eigen/SparseCore>

#include <functional>
#include <limits>

namespace abut
{
  /**
   * Two curves coupled through multipliers psi_i dual to the slave trace's shape functions phi_i: on every
   * segment int psi_i phi_j ds = delta_ij int phi_j ds. One multiplier per slave node; see Wohlmuth, SIAM J.
   * Numer. Anal. 38 (2000) 989. All integrals run over the common refinement along the slave curve with one
   * shared normal n, the averaged slave normal, for both bodies: what the multipliers do to one body they do,
   * reversed, to the other.
   *
   * On a segment that the master covers in part, the multipliers are dual on the covered part. A node whose
   * covered weight is less than 1e-6 of its whole one (5 % for degrees above 1) has no multiplier: its rows
   * and weight are zero. Choose the side that is covered wholly as slave.
   */
  struct MortarCoupling
  {
    /// int psi_i n . phi_j over the slave, with the minus sign of -u_s . n: multipliers x slave trace
    /// components.
    Eigen::SparseMatrix<double, Eigen::RowMajor> slave;
    /// +int psi_i n . phi_j over the master's points opposite: multipliers x master trace components.
    Eigen::SparseMatrix<double, Eigen::RowMajor> master;
    Eigen::VectorXd weights; ///< D_i = int phi_i over the covered part; 0: no multiplier
    Eigen::VectorXd gap;     ///< int psi_i g ds with the initial gap g (not divided by D_i)
    double covered_length = 0.;
    double smallest_gap = std::numeric_limits<double>::infinity(); ///< over the quadrature points
    double largest_gap = -std::numeric_limits<double>::infinity();
  };

  /// The initial normal gap at a slave point, whose geometric gap is the second argument.
  using GapFunction = std::function<double(const Vector2 &slave_point, double geometric_gap)>;

  /// `pieces`: the common refinement of the two curves.
  MortarCoupling couple(const Trace &slave, const Trace &master, const std::vector<Piece> &pieces,
                        const GapFunction &gap);
} // namespace abut
