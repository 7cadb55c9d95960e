// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/sparse_cholesky.h>
#include <abut/base/user_error.h>

#include <Eigen/CholmodSupport>

namespace abut
{
  struct SparseCholesky::Factor
  {
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> cholesky;
  };

  SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double> &matrix, const std::string &name)
      : factor_(std::make_unique<Factor>())
  {
    cholmod_common &settings = factor_->cholesky.cholmod();
    settings.print = 0;
    settings.nmethods =
        1; // nested dissection saves some per cent of the fill in the plane and costs far more
    settings.method[0].ordering = CHOLMOD_AMD;
    const bool is_finite = matrix.coeffs().allFinite(); // CHOLMOD accepts NaN
    if (is_finite)
      factor_->cholesky.compute(matrix);
    if (!is_finite || factor_->cholesky.info() != Eigen::Success)
      throw ComputationError(
          name +
          ": the stiffness matrix could not be factorised (not positive definite); look for cells "
          "with vanishing area, a Poisson ratio too near to 0.5, or numbers too large for the machine");
  }

  SparseCholesky::~SparseCholesky() = default;

  Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &right_sides) const
  {
    return factor_->cholesky.solve(right_sides);
  }
} // namespace abut
