// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace abut
{
  /**
   * A mesh as bare lists, before it becomes a triangulation. Vertices of a cell are in deal.II's order and
   * run counter-clockwise: a quadrilateral (0,0), (1,0), (0,1), (1,1), a triangle (0,0), (1,0), (0,1).
   */
  struct RawMesh
  {
    struct BoundaryEdge
    {
      std::array<unsigned int, 2> vertices;
      unsigned int side;
    };

    CellType cell_type = CellType::quadrilaterals;
    std::vector<Vector2> vertices;
    std::vector<std::vector<unsigned int>> cells;
    std::vector<BoundaryEdge> boundary_edges;
    std::map<std::string, unsigned int> sides; ///< names of the sides and their boundary ids

    /// Adds n[0] x n[1] quadrilaterals; index(i, j) is the vertex at column i, row j.
    void add_block(const std::array<unsigned int, 2> &n,
                   const std::function<unsigned int(unsigned int, unsigned int)> &index);

    /// Adds n edges to a side; index(i) is the vertex at their i-th end. Names the side when it is new.
    void add_side(const std::string &name, unsigned int n,
                  const std::function<unsigned int(unsigned int)> &index);
  };

  /// Turns the cells over: needed after the vertices were mirrored. Keeps the diagonals between first and
  /// last.
  void turn_cells_over(RawMesh &mesh);

  /**
   * The mesh and its mirror image across the line where coordinate `component` is zero, sewn together along
   * it. The side `seam` lies on that line (its coordinates exactly zero) and is gone in the result.
   */
  RawMesh reflect(const RawMesh &mesh, int component, const std::string &seam);

  /// Every quadrilateral cut in two along its diagonal from the first to the last vertex.
  RawMesh split_into_triangles(const RawMesh &quadrilaterals);

  /**
   * Refuses cells that have no area, are not convex or are wound the wrong way round (their straight image
   * has a Jacobian <= 0 somewhere). `where` begins the message of the UserError.
   */
  void check_cells(const RawMesh &mesh, const std::string &where);
} // namespace abut
