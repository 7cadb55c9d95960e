// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/partition.h>

#include <Eigen/SparseCore>

#include <array>
#include <functional>
#include <limits>

namespace abut
{
  /// The frame in which multipliers and gaps have components: the common normal n, outward from the cut side,
  /// and the tangent, n turned by +90 degrees, counter-clockwise around the cut side's body.
  enum Direction : std::size_t
  {
    normal_direction,
    tangential_direction,
    n_directions
  };

  /// Integrals over parts, a row for each, times trace components.
  using PartRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /**
   * What the parts of a surface see of the two sides of one link: piecewise constant multipliers psi_k, one
   * on the part k and zero elsewhere, integrated over those pieces of the parts that belong to the link, with
   * the directions d of one frame for both bodies: what the multipliers do to one body they do, reversed, to
   * the other.
   */
  struct Coupling
  {
    /// -int psi_k d . phi_j over the cut side, for every direction: parts x trace components.
    std::array<PartRows, n_directions> cut;
    /// +int psi_k d . phi_j over the other side's points opposite: parts x trace components.
    std::array<PartRows, n_directions> other;
    Eigen::VectorXd weights; ///< int psi_k; zero for parts without pieces of this link
    Eigen::VectorXd gap;     ///< int psi_k g with the initial gap g
    double covered_length = 0.;
    double smallest_gap = std::numeric_limits<double>::infinity(); ///< over the quadrature points
    double largest_gap = -std::numeric_limits<double>::infinity();
    double distance_at_smallest = 0.; ///< of the sides themselves, where the gap is smallest
    double deepest = 0.;              ///< largest overlap of the sides themselves
  };

  /// The initial normal gap at a point of the cut side.
  using GapFunction = std::function<double(const Vector2 &cut_point, const Opposite &opposite)>;

  /// `pieces`: of the link (see GapPieces), `normal`: its own.
  Coupling couple(const Surface &surface, const CommonNormal &normal, const std::vector<Piece> &pieces,
                  std::size_t n_parts, std::size_t link, const GapFunction &gap);
} // namespace abut
