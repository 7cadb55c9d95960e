// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/coupling.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  /**
   * The gap between the sides of a link as it is at single points, where Coupling has means: at equally
   * spaced points of every piece, its ends included. With trace displacements u the gaps are gap + cut u_c +
   * other u_o, along the common normal, positive where the bodies are apart.
   */
  struct GapSamples
  {
    static constexpr Eigen::Index per_piece = 5;

    Eigen::SparseMatrix<double, Eigen::RowMajor> cut; ///< samples, piece by piece, x trace components
    Eigen::SparseMatrix<double, Eigen::RowMajor> other;
    Eigen::VectorXd gap;             ///< initial
    std::vector<Piece> pieces;       ///< of the link
    std::vector<bool> other_carries; ///< for every piece: the other side, not the cut one (see Partition)
    std::vector<Vector2> places;     ///< of the samples, on the cut side
    std::vector<bool> held;          ///< whether supports hold both bodies along the normal there

    Eigen::VectorXd gaps(const Eigen::VectorXd &cut_displacement,
                         const Eigen::VectorXd &other_displacement) const
    {
      AssertDimension(cut_displacement.size(), cut.cols());
      AssertDimension(other_displacement.size(), other.cols());
      return gap + cut * cut_displacement + other * other_displacement;
    }
  };

  /// The smallest value of the parabolas through three neighbours each among equally spaced samples: exact
  /// for quadratic functions, wherever their minimum lies between the first and the last sample.
  double smallest_value(const Eigen::VectorXd &samples);

  /// `pieces`: of the link (see GapPieces), `normal`: its own.
  GapSamples sample_gaps(const Surface &surface, const CommonNormal &normal, const std::vector<Piece> &pieces,
                         std::size_t link, const GapFunction &gap);
} // namespace abut
