// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/warning.h>
#include <abut/scene/body_description.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace abut
{
  /// How the straight edges of a side of a mesh file stand for a curve.
  struct SideFacets
  {
    unsigned int n_edges = 0;
    double largest_kink = 0.; ///< between edges, degrees
    /// The largest distance between an edge and the curve behind it, whether that is followed or not. Length,
    /// own frame.
    double height = 0.;
    bool followed = false; ///< refinement and gaps follow the curve
    /// Corners that turn by less than 60 degrees with another such corner next to them: a round side in too
    /// few edges looks like this.
    unsigned int n_blunt_corners = 0;

    void serialize(Archive &archive) { archive(n_edges, largest_kink, height, followed, n_blunt_corners); }
  };

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
      /// The curve that it stands for: points at the Gauss-Lobatto nodes (LagrangeBasis) from the first
      /// vertex to the last, both included. Empty: a straight line.
      std::vector<Vector2> curve = {};
      unsigned int material = 0; ///< of its cell, see CellMaterials
    };

    CellType cell_type = CellType::quadrilaterals;
    std::vector<Vector2> vertices;
    std::vector<std::vector<unsigned int>> cells;
    bool is_one_block = false; ///< of quadrilaterals: an edge runs the same way in both of its cells
    std::vector<BoundaryEdge> boundary_edges;
    std::vector<BoundaryEdge>
        inner_edges; ///< that stand for curves inside, between materials; without a side
    std::map<std::string, unsigned int> sides; ///< names of the sides and their boundary ids
    std::vector<unsigned int> cell_materials;  ///< see CellMaterials; empty: all 0
    std::vector<Warning> warnings;             ///< what the user should hear of it
    std::map<unsigned int, SideFacets> facets; ///< by boundary id; of mesh files

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
} // namespace abut
