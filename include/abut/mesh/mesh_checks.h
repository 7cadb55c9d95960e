// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/user_error.h>
#include <abut/mesh/raw_mesh.h>

namespace abut
{
  /// Cells that cannot be computed with.
  class BadCells : public UserError
  {
  public:
    using UserError::UserError;
  };

  // What can be wrong with a mesh from elsewhere. `where` begins the message of the UserError,
  // which is BadCells where single cells are wrong.

  /**
   * Refuses cells that have no area, are not convex or are wound the wrong way round (their straight image
   * has a Jacobian <= 0 somewhere).
   */
  void check_cells(const RawMesh &mesh, const std::string &where);

  /**
   * Refuses cells that lie on each other across a common edge, and edges of more than two cells: where
   * counter-clockwise cells are folded, an edge runs the same way in two of them.
   */
  void check_unfolded(const RawMesh &mesh, const std::string &where);

  /// Refuses meshes of several parts: not every cell can be reached through edges.
  void check_connected(const RawMesh &mesh, const std::string &where);

  /// The cell on the left of every edge, whichever way it runs.
  std::map<std::array<unsigned int, 2>, std::size_t> cells_by_edge(const RawMesh &mesh);

  /// The edges of one cell alone, with the body on their left, and that cell. The mesh is not folded.
  std::map<std::array<unsigned int, 2>, std::size_t> find_boundary_edges(const RawMesh &mesh);
} // namespace abut
