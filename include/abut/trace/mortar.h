// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/mortar_parameters.h>
#include <abut/trace/surface.h>

#include <Eigen/SparseCore>

namespace abut
{
  /**
   * What makes two sides on one curve move together in the mean: int (u_s - u_m) psi = 0 for all multipliers
   * psi on the slave side determines its inner nodes,
   *
   *     u_s = D^-1 (M u_m - E u_e),   D_ij = int psi_i phi_j,   M_ij = int psi_i phi^m_j,
   *
   * in each component, from the other side's nodes and the slave's own at the ends, which stay free: there
   * the multipliers have a degree less [Bernardi1994]. Dual multipliers are those of [Wohlmuth2000]: D is
   * diagonal. On the nodes of Gauss-Lobatto rules those of degree p contain the polynomials of degree p - 1,
   * as the standard ones do. The slave's ends are where it begins and ends and where it turns by 45 degrees.
   */
  struct Mortar
  {
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    std::vector<unsigned int> slaves; ///< nodes of the slave trace, rows of the matrices
    Matrix of_slave_side;             ///< columns: its nodes; entries at ends alone
    Matrix of_master_side;            ///< columns: the master's nodes
  };

  /// Where two sides lie on each other.
  struct SideOverlap
  {
    Surface surface; ///< of the one that is cut and the other
    std::vector<CommonNormal> normals;
    std::vector<Piece> pieces;
    double share = 0.;    ///< of the length of the first side
    double farthest = 0.; ///< how far they are apart there
  };

  /// `reach`: how far the sides may overlap. Both must outlive the result.
  SideOverlap overlap_of(const Trace &side, const Trace &other, double reach);

  /// The fewest nodes of a side between two of its ends: two are needed, or the sides may turn about each
  /// other.
  std::size_t fewest_inner_nodes(const Trace &side);

  /// Of a slave all of which overlaps with the master.
  Mortar make_mortar(const SideOverlap &overlap, MortarMultipliers multipliers);
} // namespace abut
