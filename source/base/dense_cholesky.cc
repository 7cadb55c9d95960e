// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/lapack_templates.h>

#include <utility>

namespace abut
{
  DenseCholesky::DenseCholesky(Eigen::MatrixXd matrix) : factor_(std::move(matrix))
  {
    AssertDimension(factor_.rows(), factor_.cols());
    if (factor_.size() == 0)
      return;
    constexpr char lower = 'L';
    const auto n = static_cast<dealii::types::blas_int>(factor_.rows());
    dealii::types::blas_int failure = 0;
    dealii::potrf(&lower, &n, factor_.data(), &n, &failure);
    is_positive_definite_ = failure == 0 && factor_.diagonal().allFinite(); // OpenBLAS accepts NaN
  }

  Eigen::MatrixXd DenseCholesky::solve(const Eigen::MatrixXd &right_sides) const
  {
    AssertDimension(right_sides.rows(), factor_.rows());
    Assert(is_positive_definite_, dealii::ExcMessage("there is a factor"));
    Eigen::MatrixXd solutions = factor_.triangularView<Eigen::Lower>().solve(right_sides);
    factor_.triangularView<Eigen::Lower>().adjoint().solveInPlace(solutions);
    return solutions;
  }
} // namespace abut
