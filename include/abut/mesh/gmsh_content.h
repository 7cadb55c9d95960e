// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace abut
{
  /// What the Gmsh library holds; nothing is checked yet.
  struct GmshContent
  {
    struct Cell
    {
      std::vector<std::size_t> corners; ///< tags of 3 or 4 nodes, around the cell
      int region = 0;                   ///< its physical surface, 0: none
      std::vector<std::size_t> between; ///< of the nodes on its edges, in their order; empty: first order
    };
    struct Side
    {
      int id = 0;
      std::string name; ///< may be empty
    };
    /// An element of a line that has a side.
    struct Edge
    {
      std::array<std::size_t, 2> ends;
      int curve; ///< number of the curve it lies on
    };

    std::map<std::size_t, std::array<double, 3>> nodes;
    std::vector<Cell> cells;
    std::vector<Edge> edges;
    std::map<int, std::vector<Side>> sides; ///< of a curve
    std::map<int, std::string> regions;     ///< physical surfaces that have cells, and their names
    bool regions_overlap = false;           ///< a surface belongs to several
    bool has_solids = false;                ///< cells of three dimensions
    unsigned int highest_order = 0;         ///< of the cells
    bool is_geometry = false;               ///< meshed here
    /// Of edges on curves that are no straight lines, where the file is geometry: points at the Gauss-Lobatto
    /// nodes from the first end to the last.
    std::map<std::array<std::size_t, 2>, std::vector<Vector2>> curves;
  };

  // All of them throw what the library throws.

  /// Whether its present model is a geometry of a plane part without cells; if so, tells the library `Cell
  /// type` and `Mesh size` of the body. Throws UserError, beginning with `where`, for sides of `Mesh size`
  /// that it does not have.
  bool prepare_gmsh_geometry(const BodyDescription &body, const std::string &where);
  /// Meshes the geometry anew, with all sizes times a factor.
  void mesh_gmsh_geometry(double size_factor);
  /// `is_geometry`: the cells are of mesh_gmsh_geometry.
  GmshContent read_gmsh_model(bool is_geometry);

  /// `7 (bore)`.
  std::string to_string(const GmshContent::Side &side);

  /// Throws UserError, beginning with `where`, for what is no mesh of a plane body: solids, no cells, cells
  /// of higher order, z not zero, curves on several sides.
  void check_gmsh_content(const GmshContent &content, const BodyDescription &body, const std::string &where);
} // namespace abut
