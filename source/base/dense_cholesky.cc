// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/dense_cholesky.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/lapack_templates.h>

#include <utility>

// BLAS; deal.II has no template for it.
extern "C" void dtrsm_(const char *side, const char *triangle, const char *transposed, const char *diagonal,
                       const dealii::types::blas_int *n_rows, const dealii::types::blas_int *n_columns,
                       const double *factor, const double *matrix,
                       const dealii::types::blas_int *n_matrix_rows, double *right_sides,
                       const dealii::types::blas_int *n_right_side_rows);

namespace abut
{
  namespace
  {
    Eigen::MatrixXd product(const char transposed, const Eigen::Ref<const Eigen::MatrixXd> &a,
                            const Eigen::MatrixXd &b)
    {
      const Eigen::Index rows = transposed == 'T' ? a.cols() : a.rows();
      AssertDimension(transposed == 'T' ? a.rows() : a.cols(), b.rows());
      Eigen::MatrixXd result(rows, b.cols());
      if (a.size() == 0 || b.size() == 0)
        return result.setZero();
      constexpr char as_it_is = 'N';
      constexpr double one = 1., zero = 0.;
      const auto n = static_cast<dealii::types::blas_int>(rows),
                 n_columns = static_cast<dealii::types::blas_int>(b.cols()),
                 n_inner = static_cast<dealii::types::blas_int>(b.rows()),
                 n_rows = static_cast<dealii::types::blas_int>(a.outerStride());
      dealii::gemm(&transposed, &as_it_is, &n, &n_columns, &n_inner, &one, a.data(), &n_rows, b.data(),
                   &n_inner, &zero, result.data(), &n);
      return result;
    }
  } // namespace

  Eigen::MatrixXd blas_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::MatrixXd &b)
  {
    return product('N', a, b);
  }

  Eigen::MatrixXd transposed_blas_product(const Eigen::Ref<const Eigen::MatrixXd> &a,
                                          const Eigen::MatrixXd &b)
  {
    return product('T', a, b);
  }

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

  void DenseCholesky::solve_triangle(const char transposed, Eigen::MatrixXd &right_sides) const
  {
    AssertDimension(right_sides.rows(), factor_.rows());
    Assert(is_positive_definite_, dealii::ExcMessage("there is a factor"));
    if (right_sides.size() == 0)
      return;
    constexpr char left = 'L', lower = 'L', not_unit = 'N';
    constexpr double one = 1.;
    const auto n = static_cast<dealii::types::blas_int>(factor_.rows()),
               n_columns = static_cast<dealii::types::blas_int>(right_sides.cols());
    dtrsm_(&left, &lower, &transposed, &not_unit, &n, &n_columns, &one, factor_.data(), &n,
           right_sides.data(), &n);
  }

  void DenseCholesky::solve_lower(Eigen::MatrixXd &right_sides) const
  {
    solve_triangle('N', right_sides);
  }

  void DenseCholesky::solve_upper(Eigen::MatrixXd &right_sides) const
  {
    solve_triangle('T', right_sides);
  }

  void add_gram_matrix(const Eigen::MatrixXd &a, Eigen::MatrixXd &sum)
  {
    AssertDimension(sum.rows(), a.cols());
    AssertDimension(sum.cols(), a.cols());
    if (a.size() == 0)
      return;
    constexpr char lower = 'L', transposed = 'T';
    constexpr double one = 1.;
    const auto n = static_cast<dealii::types::blas_int>(a.cols()),
               k = static_cast<dealii::types::blas_int>(a.rows());
    dealii::syrk(&lower, &transposed, &n, &k, &one, a.data(), &k, &one, sum.data(), &n);
    sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  }

  Eigen::MatrixXd DenseCholesky::solve(const Eigen::MatrixXd &right_sides) const
  {
    Eigen::MatrixXd solutions = right_sides;
    solve_lower(solutions);
    solve_upper(solutions);
    return solutions;
  }
} // namespace abut
