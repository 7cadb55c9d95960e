// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>
#include <abut/trace/trace.h>

#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>

#include <functional>
#include <vector>

namespace abut
{
  using CellGeometry = std::function<Vector2(const dealii::Triangulation<2, 2>::cell_iterator &cell,
                                             const dealii::Point<2> &unit_point)>;

  /// A face of a cell.
  struct MeshEdge
  {
    dealii::DoFHandler<2>::active_cell_iterator cell;
    unsigned int face;
  };

  /**
   * The side `boundary` of a mesh as a curve, with the trace of the vector-valued space of `dof_handler` (two
   * equal scalar elements with support points on the faces). `geometry`, where points of reference cells
   * lie, is sampled as a polynomial of `geometry_degree` on each edge. Where the side consists of several
   * curves they follow one another. `processes` that share the mesh get the whole side, all of them.
   */
  Trace make_trace(const dealii::DoFHandler<2> &dof_handler, const CellGeometry &geometry,
                   unsigned int geometry_degree, dealii::types::boundary_id boundary,
                   const std::shared_ptr<Processes> &processes = nullptr);

  /// The same for edges anywhere in the mesh, with the cells named on the left.
  Trace make_trace(const std::vector<MeshEdge> &edges, const CellGeometry &geometry,
                   unsigned int geometry_degree);
} // namespace abut
