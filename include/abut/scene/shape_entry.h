// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/registry.h>
#include <abut/scene/body_description.h>

namespace dealii
{
  template <int, int> class Triangulation;
}

namespace abut
{
  struct RawMesh;

  /// What stands behind a word of `Shape`. Each shape has its own in source/mesh/.
  struct ShapeEntry
  {
    static constexpr const char *parameter = "Shape";

    std::string name, documentation;
    std::string size = {};  ///< what the numbers of Size are, each above 0: "inner radius, outer radius"
    std::string order = {}; ///< where each must be below the next: how to say so, "the inner below the outer"
    bool makes_cells = false;   ///< of a kind and number of its own, in place of Size and Cells
    bool reads_file = false;    ///< Mesh file
    bool is_rigid = false;      ///< does not deform and has no mesh: `make` is null
    bool takes_parts = false;   ///< needs `Parts`; the others have none
    bool takes_outline = false; ///< needs `Outline`; the others have none
    bool takes_grading = false; ///< `Grading` may differ from 1, 1
    bool takes_top = false;     ///< needs `Top`; the others have none
    bool has_curves = false;    ///< some sides are curves, where the cells are quadrilaterals

    /// The mesh in the body's own frame, in quadrilaterals (where it makes its own cells: with `Cell type` as
    /// far as it can); both numbers of Cells are at least 1. Boundary ids count the sides in the order of the
    /// documentation. Throws UserError where cells or sizes do not fit the shape.
    RawMesh (*make)(const BodyDescription &body) = nullptr;
    /// Cells of the coarsest mesh whose cells are about as long as wide, for numbers of Size above 0 in their
    /// order. Null where the shape makes cells of its own.
    std::array<unsigned int, 2> (*coarse_cells)(const std::vector<double> &size) = nullptr;
    /// Gives the triangulation of the placed body the curves of its sides, so that refinement and mappings of
    /// higher degree follow them. Null without curves.
    void (*attach_curves)(dealii::Triangulation<2, 2> &triangulation, const BodyDescription &body) = nullptr;
    /// H_a behind every side, in the own frame. Null: the extent of the body along the side's normal.
    double (*contact_depth)(const BodyDescription &body) = nullptr;
  };

  /// Throws UserError for a word that is none.
  inline const ShapeEntry &shape_of(const BodyDescription &body)
  {
    return Registry<ShapeEntry>::get().find(body.shape);
  }
} // namespace abut
