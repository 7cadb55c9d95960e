// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

#include <memory>
#include <string>

namespace abut
{
  /**
   * Sparse Cholesky factor of a symmetric positive definite matrix (CHOLMOD through Eigen). A factor may not
   * be used by two threads at once; different factors may.
   */
  class SparseCholesky
  {
  public:
    /// Throws ComputationError, beginning with `name`, when the matrix is not positive definite or not
    /// finite.
    SparseCholesky(const Eigen::SparseMatrix<double> &matrix, const std::string &name);
    ~SparseCholesky();

    Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
  };
} // namespace abut
