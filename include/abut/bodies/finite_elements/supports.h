// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <Eigen/SparseCore>

#include <array>
#include <string>
#include <vector>

namespace abut
{
  /**
   * One prescribed displacement component at one node: u . direction = value + per_unit delta, where delta is
   * the displacement of the scene's rigid side that carries a given resultant.
   */
  struct PrescribedComponent
  {
    std::array<unsigned int, 2> dofs;
    Vector2 place;
    Vector2 direction; ///< unit
    double value;
    double per_unit;
    std::string boundary; ///< where the condition was given
  };

  /// A supported node: one or two independent directions with the boundary that each belongs to.
  struct SupportNode
  {
    std::array<unsigned int, 2> dofs;
    std::vector<Vector2> directions;
    std::vector<std::string> boundaries;
  };

  /**
   * All supports of a body, as the affine set u = T v + fixed + delta moving: T has orthonormal columns, two
   * for a free node, one (along the free direction) for a roller, none for a held node.
   */
  struct Supports
  {
    Eigen::SparseMatrix<double> free_directions; ///< T, n_dofs x n_free
    Eigen::VectorXd fixed;
    Eigen::VectorXd moving;
    std::vector<SupportNode> nodes;
  };

  /**
   * Solves the at most 2 x 2 system of the components given at each node. `node_dofs` lists the nodes that
   * are free to move, all but the hanging ones, whose rows of T are zero; `n_dofs` counts all unknowns.
   * Throws UserError, beginning with `body`, with the place of a node where conditions contradict one
   * another.
   */
  Supports make_supports(const std::string &body, const std::vector<std::array<unsigned int, 2>> &node_dofs,
                         Eigen::Index n_dofs, const std::vector<PrescribedComponent> &components);

  /// u(x) = translation + rotation (x - centre)^perp / size: a rigid motion, small.
  struct RigidMode
  {
    Vector2 translation;
    double rotation;
    Vector2 centre;
    double size;

    Vector2 displacement(const Vector2 &place) const
    {
      const Vector2 arm = (place - centre) / size;
      return translation + rotation * Vector2(-arm.y(), arm.x());
    }
    /// "translation along (1, 0)", "rotation about (0, 2)"
    std::string description() const;
  };

  /**
   * The rigid motions that the components leave free; empty for a supported body. Decided by the rank of the
   * components on the three rigid modes: a Cholesky factorisation does not notice a singular matrix.
   */
  std::vector<RigidMode> free_rigid_modes(const std::vector<PrescribedComponent> &components,
                                          const Vector2 &centre, double size);
} // namespace abut
