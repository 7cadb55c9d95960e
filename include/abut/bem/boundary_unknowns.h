// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/bem/boundary_space.h>

#include <vector>

namespace abut
{
  /// Tractions (Legendre coefficients) and displacements (at the nodes) on the whole boundary, G = 1, in the
  /// lengths of the BoundarySpace.
  struct BoundaryState
  {
    Eigen::VectorXd traction;
    Eigen::VectorXd displacement;
  };

  /// The directions along which the displacement of every node is given: those of its elements; where they
  /// differ both axes, but the mean where they differ by less than 45 degrees on one side, which is a curve
  /// then.
  std::vector<std::vector<Vector2>> supported_at_nodes(const BoundarySpace &space,
                                                       const std::vector<std::vector<Vector2>> &supported);

  /**
   * What is unknown of tractions and displacements on a boundary: on each element the tractions along its
   * supported directions, at each node the displacement along the others.
   */
  class BoundaryUnknowns
  {
  public:
    /// See BoundaryProblem.
    BoundaryUnknowns(const BoundarySpace &space, const std::vector<std::vector<Vector2>> &supported,
                     unsigned int traction_degree);

    const BoundarySpace &space() const { return space_; }
    /// Legendre coefficients from the unknown tractions, a column for each; ordered by elements.
    const Eigen::SparseMatrix<double> &tractions() const { return tractions_; }
    /// Displacement vector from its unknowns, with orthonormal columns.
    const Eigen::SparseMatrix<double> &displacements() const { return displacements_; }
    /// Densities from the unknown displacements.
    const DisplacementBasis &free() const { return free_; }
    Eigen::Index size() const { return tractions_.cols() + displacements_.cols(); }

    /// The rigid motions that the supports leave free: displacement vectors of length 1.
    const Eigen::MatrixXd &rigid_motions() const { return rigid_; }
    /// The same of each hole by itself.
    const Eigen::MatrixXd &hole_motions() const { return hole_motions_; }
    /// Both, in the unknown displacements.
    Eigen::MatrixXd motions() const;

    /// What is given of a displacement vector: its part along supported directions.
    Eigen::VectorXd given(const Eigen::VectorXd &displacement) const;
    DisplacementBasis densities(const Eigen::VectorXd &displacement) const;
    /// <left, right>
    LegendreBasis mass(const LegendreBasis &left, const LegendreBasis &right) const;
    /// Over the boundary, of both components of every column.
    Eigen::MatrixX2d integrals(const LegendreBasis &basis) const;
    /// Throws ComputationError where a load is not balanced about a rigid motion.
    void check_balance(const BoundaryState &known) const;

  private:
    Eigen::VectorXd lengths() const;
    void choose(const std::vector<std::vector<Vector2>> &supported, unsigned int traction_degree);
    Eigen::MatrixXd free_motions(const std::vector<unsigned int> &nodes) const;
    void find_rigid_motions();

    const BoundarySpace &space_;
    Eigen::SparseMatrix<double> tractions_, displacements_;
    DisplacementBasis free_;
    Eigen::MatrixXd rigid_, hole_motions_;
  };
} // namespace abut
