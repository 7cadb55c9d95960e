// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

#include <memory>
#include <string>
#include <vector>

namespace abut
{
  /**
   * Sparse Cholesky factor of a symmetric positive definite matrix (CHOLMOD). A factor may not be used by two
   * threads at once; different factors may.
   *
   * Unknowns may be named that are eliminated last. The last columns of the factor are then the Cholesky
   * factor of the Schur complement on these unknowns, all that a solve needs which begins and ends on them.
   */
  class SparseCholesky
  {
  public:
    /// `last`: the unknowns that are eliminated last, none twice. Throws ComputationError, beginning with
    /// `name`, when the matrix is not positive definite or not finite.
    SparseCholesky(const Eigen::SparseMatrix<double> &matrix, const std::string &name,
                   const std::vector<int> &last = {});
    ~SparseCholesky();

    Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;
    /// The solutions at the unknowns `last` for right sides that vanish at all others; rows in the order of
    /// `last`.
    Eigen::MatrixXd solve_last(const Eigen::MatrixXd &right_sides) const;

  private:
    struct LastSupernodes;
    struct Factor;
    std::unique_ptr<Factor> factor_;
  };
} // namespace abut
