// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// Functions that test whether the displacements of two sides are equal.
  enum class MortarMultipliers
  {
    dual,    ///< biorthogonal to the slave's shape functions: D is diagonal
    standard ///< the slave's shape functions
  };

  /// Whose nodes follow the other side's.
  enum class MortarSlave
  {
    automatic, ///< of glued sides the softer, of equally soft ones the finer; at edges of finer cells these
    finer,
    coarser
  };

  /// Vertices where cells meet finer ones.
  enum class MortarVertices
  {
    tied, ///< both have one displacement there
    free  ///< each has its own
  };

  /// What the section `Mortar` says.
  struct MortarParameters
  {
    MortarMultipliers multipliers = MortarMultipliers::dual;
    MortarSlave slave = MortarSlave::automatic;
    MortarVertices vertices = MortarVertices::tied;
    bool neighbour_rule = false; ///< also split glued cells with an edge that has more than two neighbours

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static MortarParameters parse(const dealii::ParameterHandler &prm);
  };

  /// Which sides of one body are glued.
  struct GlueDescription
  {
    struct Pair
    {
      std::string slave, master;
    };

    bool automatic = false;  ///< all sides of different parts that coincide
    std::vector<Pair> pairs; ///< in the order of the text

    bool is_empty() const { return !automatic && pairs.empty(); }
  };

  /// How the meshes inside a body are joined where they do not match.
  struct JointDescription
  {
    GlueDescription glue;
    MortarParameters mortar;
    bool mortar_edges = false; ///< edges between a cell and finer ones by mortar, not by hanging nodes
  };

  /// Reads `automatic`, `none` or `base.top - insert.bottom; ...`, the slave first. Throws UserError,
  /// beginning with `where`.
  GlueDescription parse_glue(const std::string &text, const std::string &where);
} // namespace abut
