// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/legendre_moments.h>

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /// A row for every degree on one element, a column for every degree on another; kept without allocation.
  using PairBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                  max_density_degree + 1, max_density_degree + 1>;

  /**
   * Integrals over x on a first and y on a second element, w = y - x, against P_i(x) P_j(y):
   *
   *   log          = int int P_i P_j ln |w|
   *   even         = int int P_i P_j conj(w)/w, real and imaginary part
   *   double_layer = -(1/2 pi) Im(second.direction int int P_i P_j/w)
   *   reversed     = double_layer of the elements in the other order, transposed
   *                = (1/2 pi) Im(first.direction int int P_i P_j/w)
   *
   * Against n(y), the outward normal, the double layer has the kernel d/dn(y) of -ln |w|/(2 pi).
   */
  struct PairIntegrals
  {
    explicit PairIntegrals(unsigned int degree);

    PairBlock log, even_real, even_imag, double_layer, reversed;
  };

  /// The distance between two elements.
  double distance(const BoundaryElement &a, const BoundaryElement &b);

  /**
   * Whether the ends of the shorter element lie on the line through the longer one up to `round_off`, the
   * rounding of coordinates, as it grows with the distance along that line: then their double layer is zero.
   */
  bool collinear(const BoundaryElement &a, const BoundaryElement &b, double round_off);

  /**
   * An element with itself, in closed form: int int P_i(s) P_j(t) ln|s - t| over -1 < s, t < 1 from
   * int P_i Q_j = (1 - (-1)^(i+j))/((i - j)(i + j + 1)) (Gradshteyn & Ryzhik 7.113).
   */
  PairIntegrals self_integrals(const BoundaryElement &element, unsigned int degree);
} // namespace abut
