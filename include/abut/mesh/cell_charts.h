// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/lagrange_basis.h>
#include <abut/mesh/raw_mesh.h>

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <map>
#include <memory>
#include <vector>

namespace dealii
{
  template <int, int> class Mapping;
}

namespace abut
{
  /**
   * The cells that a mesh began with as smooth images of the reference cell, whose edges on the boundary
   * follow curves. What refinement makes of such a cell are pieces of that one image: new vertices lie on the
   * curves, inner edges follow them. But edges between a cell and finer ones are straight, for both: so the
   * cells fit, and what is linear in the plane is a field.
   *
   * Blending: quadrilaterals after Coons, triangles after Szabo and Babuska (Finite Element Analysis, 1991,
   * ch. 6): what an edge deviates from its chord fades towards the opposite side.
   */
  class CellCharts
  {
  public:
    /// Of a mesh as it is created, not refined; edges without a curve are straight.
    CellCharts(const dealii::Triangulation<2, 2> &triangulation,
               const std::vector<RawMesh::BoundaryEdge> &edges);

    /// The image of points of a cell's reference cell; the cell may be a descendant of any level.
    std::vector<dealii::Point<2>> points(const dealii::Triangulation<2, 2>::cell_iterator &cell,
                                         const std::vector<dealii::Point<2>> &unit_points) const;

    /// Puts every vertex of a refined mesh where the charts have it, those on edges of coarser cells into
    /// their middle.
    void place_vertices(dealii::Triangulation<2, 2> &triangulation);

    /// Polynomials of a degree (triangles: 1 or 2) that interpolate the charts in every cell. The charts must
    /// outlive it.
    std::unique_ptr<dealii::Mapping<2, 2>> mapping(bool triangles, unsigned int degree) const;

  private:
    /// What a face deviates from its chord, from its first vertex in the reference cell on.
    struct Deviation
    {
      explicit Deviation(const std::vector<Vector2> &curve);
      Vector2 at(double s) const;

      LagrangeBasis basis;
      Eigen::Matrix2Xd at_nodes;
    };
    using CurvedFaces = std::map<unsigned int, Deviation>;

    static Vector2 blended(const dealii::ReferenceCell &reference, const CurvedFaces &faces,
                           const dealii::Point<2> &unit);

    std::vector<dealii::Point<2>> charted(const dealii::Triangulation<2, 2>::cell_iterator &cell,
                                          const std::vector<dealii::Point<2>> &unit_points) const;
    bool is_charted(const dealii::Triangulation<2, 2>::cell_iterator &cell) const;
    /// The shift of a point by the vertices that have been moved off the charts.
    Vector2 shift_of_vertices(const dealii::Triangulation<2, 2>::cell_iterator &cell,
                              const dealii::Point<2> &unit) const;
    /// What edges between the cell and finer or coarser ones deviate from their chords.
    CurvedFaces uneven_faces(const dealii::Triangulation<2, 2>::cell_iterator &cell) const;

    std::map<int, CurvedFaces> cells_;      // by index on level 0
    std::map<unsigned int, Vector2> moved_; // vertices, by index: how far off the charts
  };
} // namespace abut
