// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/dense_cholesky.h>
#include <abut/bem/boundary_unknowns.h>

namespace abut
{
  /**
   * The mixed boundary value problem of plane strain by symmetric Galerkin boundary elements (Sirtori;
   * Hartmann, Katz and Protopsaltis; see [Bonnet1998]). On each element the displacement is given along its
   * supported directions, the traction along the others, and the unknowns are what is not given:
   *
   *   [ V_DD  -K_DN ; K_DN^T  W_NN ] [ t ; u ] = [ (M/2 + K) u_D - V t_N ; (M^T/2 - K^T) t_N - W u_D ]
   *
   * Cholesky of V_DD, then of W_NN + K_DN^T V_DD^-1 K_DN, both scaled to a unit diagonal: made once, used for
   * every load. Displacements are given at the nodes that touch a supported element (supported_at_nodes);
   * where supports follow a polygon, tractions do no work on what is free there. Rigid motions that the
   * supports leave free are fixed by a term of their rank, which does not change the stress of a balanced
   * load. So are those of each hole by itself, which V t = (M/2 + K) u at the hole yields afterwards: a rigid
   * displacement of the curve of a hole has no stress outside, W r = 0 and (M/2 - K) r = 0.
   */
  class BoundaryProblem
  {
  public:
    /// `supported`: unit directions, none, one or two, for every element. Tractions are sought in polynomials
    /// of `traction_degree`. The space must outlive the problem. Throws ComputationError where a matrix is
    /// not positive definite.
    BoundaryProblem(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                    unsigned int traction_degree, double poisson_ratio, const GalerkinRule &rule);

    /**
     * `known.traction` counts along directions that are not supported and must vanish along the others,
     * `known.displacement` along supported ones (else it is disregarded). Throws ComputationError where the
     * load is not balanced about a rigid motion that the supports leave free.
     */
    BoundaryState solve(const BoundaryState &known) const;

    Eigen::Index n_unknowns() const { return unknowns_.size(); }
    Eigen::Index n_free_rigid_motions() const { return unknowns_.rigid_motions().cols(); }

  private:
    void factorise();
    /// Moves each hole as the traction demands.
    void place_holes(BoundaryState &state) const;

    BoundaryUnknowns unknowns_;
    LayerOperators operators_;
    Eigen::VectorXd traction_scale_, displacement_scale_;
    Eigen::MatrixXd mixed_; ///< K_DN, scaled
    DenseCholesky single_layer_{Eigen::MatrixXd()}, schur_complement_{Eigen::MatrixXd()};
  };
} // namespace abut
