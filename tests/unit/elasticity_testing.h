// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/elasticity/body.h>

#include "mesh_testing.h"

namespace abut
{
  inline void set_conditions(BodyDescription &body, const std::string &text)
  {
    body.conditions = parse_conditions(text, {}, "test");
  }

  /// Largest difference of a displacement from a given field over all nodes.
  inline double distance(const Body &body, const Eigen::VectorXd &displacement,
                         const std::function<Vector2(const Vector2 &)> &field)
  {
    const Nodes nodes = all_nodes(body.space());
    double largest = 0.;
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
    {
      const Vector2 u(displacement[nodes.dofs[i][0]], displacement[nodes.dofs[i][1]]);
      largest = std::max(largest, (u - field(nodes.places[i])).norm());
    }
    return largest;
  }

  struct Variant
  {
    CellType type;
    unsigned int degree;
  };
  inline const Variant variants[] = {{CellType::quadrilaterals, 1},
                                     {CellType::quadrilaterals, 2},
                                     {CellType::quadrilaterals, 3},
                                     {CellType::triangles, 1},
                                     {CellType::triangles, 2}};

  /// Splits, again and again, the cells that are no further than their size from a point (own frame).
  inline void refine_towards(Body &body, const Vector2 &own_point, const unsigned int passes)
  {
    const Vector2 goal = body.description().placement.point_to_world(own_point);
    for (unsigned int pass = 0; pass < passes; ++pass)
    {
      const auto &triangulation = body.space().mesh().triangulation;
      CellMarks marks = no_marks(triangulation);
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        const auto centre = cell->center();
        marks.refine[cell->active_cell_index()] =
            (Vector2(centre[0], centre[1]) - goal).norm() < cell->diameter();
      }
      body.adapt(marks, {});
    }
  }

  /// The displacement of a body that nothing touches.
  inline Eigen::VectorXd untouched(Body &body)
  {
    body.prepare();
    return body.displacement(Eigen::VectorXd::Zero(body.trace_size()), 0.);
  }
} // namespace abut
