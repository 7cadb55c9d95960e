// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/body_description.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>

namespace dealii
{
  template <int, int> class Mapping;
}

namespace abut
{
  /// The mesh of one body, where the body lies in the plane.
  struct BodyMesh
  {
    std::string name; ///< of the body
    CellType cell_type = CellType::quadrilaterals;
    /// Some sides follow curves: never those of triangles and of mesh files, whose sides are polygons.
    bool curved = false;
    /// The sides and their boundary ids; sides of a mesh file are called by their physical id, e.g. "7". They
    /// keep the names they have in the body's own frame, however it is turned or mirrored.
    std::map<std::string, dealii::types::boundary_id> boundaries;
    /// In world coordinates. Its manifolds keep refined meshes on curved sides.
    dealii::Triangulation<2> triangulation;

    /// Polynomials of the given degree on curved quadrilaterals; straight cells need and get no more than 1.
    std::unique_ptr<dealii::Mapping<2, 2>> mapping(unsigned int degree) const;
  };

  /**
   * Builds or reads the mesh and places it. Throws UserError: cells that do not fit the shape, a mesh file
   * that cannot be used, cells that are too distorted (a Jacobian <= 0).
   */
  std::unique_ptr<BodyMesh> make_mesh(const BodyDescription &body);

  /// The id of a side. Throws UserError with the names of the body's sides.
  dealii::types::boundary_id boundary_id(const BodyMesh &mesh, const std::string &side);

  /**
   * H_a of the penalty parameter and of the elastic layer, in world lengths: the depth of the body behind a
   * side. `Contact depth` (times `Scale`) where given; else the radius of a disc or a part of it, the
   * difference of the radii of rings, and for other shapes the extent of the body along the mean outward
   * normal of the side (half of the body's diameter where that mean vanishes, e.g. around a hole).
   */
  double contact_depth(const BodyDescription &body, const BodyMesh &mesh, dealii::types::boundary_id side);
} // namespace abut
