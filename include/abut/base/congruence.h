// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

namespace abut
{
  /**
   * The lower triangle of T^T A T, rows in order, for a symmetric A of which all entries are stored. One pass
   * over the entries: where T has about one of them in a row, as that of constraints, several times faster
   * than two products of sparse matrices.
   */
  Eigen::SparseMatrix<double> lower_congruent(const Eigen::SparseMatrix<double> &a,
                                              const Eigen::SparseMatrix<double> &t);
} // namespace abut
