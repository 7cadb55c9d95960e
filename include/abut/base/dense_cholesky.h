// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /// Cholesky factor of a symmetric matrix by LAPACK, which takes about half the time of Eigen's where the
  /// matrix is large.
  class DenseCholesky
  {
  public:
    /// Reads the lower triangle.
    explicit DenseCholesky(Eigen::MatrixXd matrix);

    /// Of the matrix. There are solutions only where it is.
    bool is_positive_definite() const { return is_positive_definite_; }
    Eigen::Index rows() const { return factor_.rows(); }
    Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;

  private:
    Eigen::MatrixXd factor_; ///< in the lower triangle
    bool is_positive_definite_ = true;
  };
} // namespace abut
