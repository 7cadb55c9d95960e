// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/dense_cholesky.h>
#include <abut/bem/boundary_problem.h>

namespace abut
{
  /**
   * By matrices: Cholesky of V_DD, then of W_NN + K_DN^T V_DD^-1 K_DN, both scaled to a unit diagonal, made
   * once and used for every load.
   */
  class DenseBoundaryProblem : public BoundaryProblem
  {
  public:
    /// See BoundaryProblem. Throws ComputationError where a matrix is not positive definite.
    DenseBoundaryProblem(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                         unsigned int traction_degree, double poisson_ratio, const GalerkinRule &rule);

  private:
    void factorise();
    AllKernels kernels(double tolerance) const override;
    std::optional<Eigen::VectorXd> solve_system(const Eigen::VectorXd &right_side,
                                                const Eigen::VectorXd &guess, const Kernels &far,
                                                double tolerance) const override;

    LayerOperators operators_;
    Eigen::VectorXd traction_scale_, displacement_scale_;
    Eigen::MatrixXd mixed_; ///< K_DN, scaled
    DenseCholesky single_layer_{Eigen::MatrixXd()}, schur_complement_{Eigen::MatrixXd()};
  };
} // namespace abut
