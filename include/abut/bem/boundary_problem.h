// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_space.h>
#include <abut/vector2.h>

#include <Eigen/Cholesky>

namespace abut
{
  /// Tractions (Legendre coefficients) and displacements (at the nodes) on the whole boundary, G = 1, in the
  /// lengths of the BoundarySpace.
  struct BoundaryState
  {
    Eigen::VectorXd traction;
    Eigen::VectorXd displacement;
  };

  /// The directions along which the displacement of every node is given: those of its elements, their mean
  /// where they differ by less than 45 degrees, else both axes.
  std::vector<std::vector<Vector2>> supported_at_nodes(const BoundarySpace &space,
                                                       const std::vector<std::vector<Vector2>> &supported);

  /**
   * The mixed boundary value problem of plane strain by symmetric Galerkin boundary elements (Sirtori;
   * Hartmann, Katz and Protopsaltis; see Bonnet, Maier and Polizzotto, Appl. Mech. Rev. 51 (1998) 669). On
   * each element the displacement is given along its supported directions, the traction along the others, and
   * the unknowns are what is not given:
   *
   *   [ V_DD  -K_DN ; K_DN^T  W_NN ] [ t ; u ] = [ (M/2 + K) u_D - V t_N ; (M^T/2 - K^T) t_N - W u_D ]
   *
   * Cholesky of V_DD, then of W_NN + K_DN^T V_DD^-1 K_DN, both scaled to a unit diagonal: made once, used for
   * every load. Displacements are given at the nodes that touch a supported element (supported_at_nodes);
   * where supports follow a polygon, tractions do no work on what is free there. Rigid motions that the
   * supports leave free are fixed by a term of their rank, which does not change the stress of a balanced
   * load. So are those of a hole by itself, which these equations leave open whatever its load, and which
   * make no stress in the body either (Vodicka, Mantic and Paris, IJNME 66 (2006)).
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

    Eigen::Index n_unknowns() const { return tractions_.cols() + displacements_.cols(); }
    Eigen::Index n_free_rigid_motions() const { return rigid_.cols(); }

  private:
    void choose_unknowns(const std::vector<std::vector<Vector2>> &supported, unsigned int traction_degree);
    void find_rigid_motions();
    /// Those of the unit motions (displacement vectors) that the supports leave free, unit columns.
    Eigen::MatrixXd unhindered(const Eigen::MatrixXd &motions) const;
    void add_motions_of_holes(const Eigen::MatrixXd &motions);
    void factorise();
    void check_balance(const Eigen::VectorXd &traction) const;

    const BoundarySpace &space_;
    LayerOperators operators_;
    Eigen::SparseMatrix<double> tractions_;     ///< Legendre coefficients from the unknown tractions
    Eigen::SparseMatrix<double> displacements_; ///< displacement vector from its unknowns, orthonormal
    DisplacementBasis free_;                    ///< densities from the unknown displacements
    Eigen::MatrixXd rigid_;                     ///< free rigid motions: displacement vectors, orthonormal
    Eigen::MatrixXd undetermined_;              ///< the same and those of holes
    Eigen::VectorXd traction_scale_, displacement_scale_;
    Eigen::MatrixXd mixed_; ///< K_DN, scaled
    Eigen::LLT<Eigen::MatrixXd> single_layer_, schur_complement_;
  };
} // namespace abut
