// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

namespace abut
{
  /**
   * A basis of fields on the boundary: a column for every unknown, a row for every component, element and
   * Legendre polynomial; row = component n + element (degree + 1) + degree of the polynomial, n the size of
   * the KernelMatrices.
   */
  using LegendreBasis = Eigen::SparseMatrix<double>;

  /// Continuous displacements, or one such displacement as a single column.
  struct DisplacementBasis
  {
    LegendreBasis values;
    LegendreBasis slopes; ///< derivatives with respect to arc length, with the body on the left
  };
} // namespace abut
