// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_pieces.h>
#include <abut/bem/elastic_kernels.h>
#include <abut/bem/fast_kernels.h>

#include <optional>

namespace abut
{
  /**
   * The mixed problem of BoundaryProblem without its matrices: [V_DD, -K_DN; K_DN^T, W_NN] is multiplied with
   * by FastKernels, and the system solved by GMRES with BoundaryPieces as preconditioner.
   */
  class FastBoundaryProblem
  {
  public:
    /// As BoundaryProblem's.
    FastBoundaryProblem(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                        unsigned int traction_degree, double poisson_ratio, const GalerkinRule &rule);

    /// As BoundaryProblem's, to a relative accuracy; none where the iteration does not get there.
    std::optional<BoundaryState> solve(const BoundaryState &known, double tolerance) const;

    Eigen::Index n_unknowns() const { return unknowns_.size(); }
    /// Of the last solution.
    unsigned int n_steps() const { return n_steps_; }

  private:
    /// Legendre coefficients of V t - K u; of K^T t + W u against the values and the slopes of displacements.
    struct Products
    {
      Eigen::VectorXd traction, value, slope;
    };

    /// A kernel's potential of a density, from its two products.
    Eigen::VectorXcd potential(const ElasticKernels::Kernel &kernel, const Eigen::VectorXcd &density,
                               const Eigen::VectorXcd &log, const Eigen::VectorXcd &even) const;
    Products multiply(const Eigen::VectorXd &traction, const DisplacementBasis &displacement,
                      const FastKernels::Expansions &expansions) const;
    /// The whole operator.
    Eigen::VectorXd multiply(const Eigen::VectorXd &x, const FastKernels::Expansions &expansions) const;
    Eigen::VectorXd on_unknowns(const Products &products) const;
    /// See BoundaryProblem.
    void place_holes(BoundaryState &state, const FastKernels::Expansions &expansions) const;

    BoundaryUnknowns unknowns_;
    FastKernels kernels_;
    ElasticKernels elastic_;
    BoundaryPieces pieces_;
    mutable unsigned int n_steps_ = 0;
  };
} // namespace abut
