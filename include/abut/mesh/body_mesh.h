// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>
#include <abut/mesh/cell_charts.h>
#include <abut/scene/body_description.h>

#include <deal.II/grid/tria.h>

#include <functional>
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
    /// Without any cells yet. `processes`: that will share it; null: this one has it alone.
    explicit BodyMesh(std::shared_ptr<Processes> processes = nullptr,
                      dealii::Triangulation<2>::MeshSmoothing smoothing = dealii::Triangulation<2>::none);

    std::string name; ///< of the body
    CellType cell_type = CellType::quadrilaterals;
    /// Some sides follow curves: never those of triangles in built-in shapes, whose sides are polygons.
    bool curved = false;
    /// The sides and their boundary ids; sides of a mesh file are called by their physical id, e.g. "7", and
    /// by their physical name. They keep the names they have in the body's own frame, however it is turned or
    /// mirrored.
    std::map<std::string, dealii::types::boundary_id> boundaries;
    std::vector<Warning> warnings;             ///< what the user should hear of it
    std::map<unsigned int, SideFacets> facets; ///< of the sides of a mesh file; heights in world lengths
    /// Each of which knows its own cells and those around them, in this process; null: it has all.
    const std::shared_ptr<Processes> processes;
    /// How often its coarsest cells were split to begin with: they are not merged any further.
    unsigned int first_level = 0;

  private:
    std::unique_ptr<dealii::Triangulation<2>> owned_;

  public:
    /// In world coordinates. Its manifolds, or the charts, keep refined meshes on curved sides.
    dealii::Triangulation<2> &triangulation;
    std::unique_ptr<CellCharts> charts; ///< of curved meshes from files

    /// Polynomials of the given degree on curved cells (triangles: 1 or 2); straight cells need and get no
    /// more than 1.
    std::unique_ptr<dealii::Mapping<2, 2>> mapping(unsigned int degree) const;

    using Cell = dealii::Triangulation<2, 2>::cell_iterator;
    /// Where points of a cell's reference cell lie: on curves where the body has them, or next to them by
    /// polynomials of the given degree.
    std::function<Vector2(const Cell &cell, const dealii::Point<2> &unit)>
    geometry(unsigned int degree) const;
  };

  /**
   * Builds or reads the mesh and places it. Throws UserError: cells that do not fit the shape, a mesh file
   * that cannot be used, cells that are too distorted (a Jacobian <= 0).
   *
   * `processes` that share the mesh begin with larger cells, which all of them know: `split_to_size` makes
   * those that the body asks for, when the sides have their names. All processes have to call both.
   */
  std::unique_ptr<BodyMesh> make_mesh(const BodyDescription &body,
                                      std::shared_ptr<Processes> processes = nullptr);
  void split_to_size(BodyMesh &mesh);

  /// Refuses distorted cells as `make_mesh` does, in all processes that share the mesh.
  void check_jacobians(const BodyMesh &mesh, unsigned int degree, const std::string &where);

  /// The id of a side. Throws UserError with the names of the body's sides.
  dealii::types::boundary_id boundary_id(const BodyMesh &mesh, const std::string &side);

  /// Makes one side, with the name `a + b`, of sides that are taken together; they lose their own names. A
  /// name without a plus, or of a side, changes nothing. Throws UserError for a part that is no side any
  /// more, or twice there.
  void unite_sides(BodyMesh &mesh, const std::string &name);

  /// Does so for all sides that the body's conditions and glue name.
  void unite_named_sides(BodyMesh &mesh, const BodyDescription &body);

  /**
   * H_a of the penalty parameter and of the elastic layer, in world lengths: the depth of the body behind a
   * side. `Contact depth` (times `Scale`) where given; else the radius of a disc or a part of it, the
   * difference of the radii of rings, and for other shapes the extent of the body along the mean outward
   * normal of the side (half of the body's diameter where that mean vanishes, e.g. around a hole).
   */
  double contact_depth(const BodyDescription &body, const BodyMesh &mesh, dealii::types::boundary_id side);
} // namespace abut
