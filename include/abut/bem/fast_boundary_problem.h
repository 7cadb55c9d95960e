// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_pieces.h>
#include <abut/bem/boundary_problem.h>
#include <abut/bem/fast_kernels.h>
#include <abut/bem/near_system.h>

namespace abut
{
  /**
   * [V_DD, -K_DN; K_DN^T, W_NN] is multiplied with by NearSystem and, what is far, FastKernels, and the
   * system solved by GMRES with BoundaryPieces as preconditioner.
   */
  class FastBoundaryProblem : public BoundaryProblem
  {
  public:
    /// See BoundaryProblem.
    FastBoundaryProblem(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                        unsigned int traction_degree, double poisson_ratio, const GalerkinRule &rule);

  private:
    AllKernels kernels(double tolerance) const override;
    std::optional<Eigen::VectorXd> solve_system(const Eigen::VectorXd &right_side,
                                                const Eigen::VectorXd &guess, const Kernels &far,
                                                double tolerance) const override;
    /// The whole operator.
    Eigen::VectorXd multiply_unknowns(const Eigen::VectorXd &x, const Kernels &far) const;
    /// Solves until the preconditioned residual is below `error`; none where it does not get there.
    std::optional<Eigen::VectorXd> iterate(const Eigen::VectorXd &right_side, const Kernels &far,
                                           double error) const;

    FastKernels kernels_;
    NearSystem near_;
    BoundaryPieces pieces_;
  };
} // namespace abut
