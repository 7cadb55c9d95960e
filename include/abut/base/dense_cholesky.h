// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /// Cholesky factor L of a symmetric matrix by LAPACK and BLAS, which take about half the time of Eigen
  /// where the matrix is large.
  class DenseCholesky
  {
  public:
    /// Reads the lower triangle.
    explicit DenseCholesky(Eigen::MatrixXd matrix);

    /// Of the matrix. There are solutions only where it is.
    bool is_positive_definite() const { return is_positive_definite_; }
    Eigen::Index rows() const { return factor_.rows(); }
    Eigen::MatrixXd solve(const Eigen::MatrixXd &right_sides) const;
    /// L^-1 x and L^-T x, in place of x.
    void solve_lower(Eigen::MatrixXd &right_sides) const;
    void solve_upper(Eigen::MatrixXd &right_sides) const;

  private:
    void solve_triangle(char transposed, Eigen::MatrixXd &right_sides) const;

    Eigen::MatrixXd factor_; ///< in the lower triangle
    bool is_positive_definite_ = true;
  };

  /// A B and A^T B, by BLAS, which is much faster than Eigen where B has few columns.
  Eigen::MatrixXd blas_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::MatrixXd &b);
  Eigen::MatrixXd transposed_blas_product(const Eigen::Ref<const Eigen::MatrixXd> &a,
                                          const Eigen::MatrixXd &b);

  /// Adds A^T A to a symmetric matrix, by BLAS.
  void add_gram_matrix(const Eigen::MatrixXd &a, Eigen::MatrixXd &sum);
} // namespace abut
