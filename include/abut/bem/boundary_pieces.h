// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/near_system.h>

#include <Eigen/LU>

#include <vector>

namespace abut
{
  /**
   * A preconditioner for [V_DD, -K_DN; K_DN^T, W_NN]: solves exactly on pieces of the boundary that overlap
   * by a few elements, and keeps of each solution what is the piece's own (restricted additive Schwarz). A
   * piece has what lies close together, opposite sides of a thin body included.
   */
  class BoundaryPieces
  {
  public:
    BoundaryPieces(const BoundaryUnknowns &unknowns, const NearSystem &near);

    Eigen::VectorXd solve(const Eigen::VectorXd &right_side) const;
    /// What keeps free rigid motions and those of holes from making W singular: a term of their rank, of the
    /// size of W.
    Eigen::VectorXd hold_motions(const Eigen::VectorXd &displacements) const;

  private:
    struct Piece
    {
      std::vector<Eigen::Index> unknowns; ///< tractions first
      std::vector<Eigen::Index> own;      ///< places among them
      Eigen::PartialPivLU<Eigen::MatrixXd> factor;
    };

    Eigen::MatrixXd motions_; ///< in the unknown displacements
    double weight_ = 0.;
    std::vector<Piece> pieces_;
  };
} // namespace abut
