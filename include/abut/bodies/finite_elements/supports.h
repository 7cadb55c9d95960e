// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/prescribed.h>

#include <Eigen/SparseCore>

namespace abut
{
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
} // namespace abut
