// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/nodes.h>

#include "mesh_testing.h"

namespace abut
{
  inline void set_conditions(BodyDescription &body, const std::string &text)
  {
    body.conditions = parse_conditions(text, {}, "test");
  }

  /// A linear displacement of the own frame as a condition's formulas and, placed with the scale 1.5, as a
  /// field.
  inline const std::string linear_formulas = "1e-2*(1 + 2*x - y), 1e-2*(3 + x + 4*y)";
  inline Vector2 linear_field(const Placement &placement, const Vector2 &point)
  {
    const Vector2 own = placement.point_to_own(point);
    return 1.5e-2 *
           placement.direction_to_world(Vector2(1. + 2. * own.x() - own.y(), 3. + own.x() + 4. * own.y()));
  }

  /// `displacement: formulas` on each of these sides.
  inline std::string displaced_sides(const std::vector<std::string> &sides, const std::string &formulas)
  {
    std::string conditions;
    for (const std::string &side : sides)
      conditions += (conditions.empty() ? "" : "; ") + side + ": displacement: " + formulas;
    return conditions;
  }

  /// Graded, turned and mirrored, three by two units in six cells.
  inline BodyDescription turned_plate(const CellType type, const unsigned int degree, const double scale)
  {
    auto body = make_body("rectangle", {3., 2.}, {{3, 2}});
    body.grading = {{2., .5}};
    body.cell_type = type;
    body.degree = degree;
    body.placement = Placement(scale, true, 25., Vector2(2., 1.));
    body.young_modulus = 2.6;
    body.poisson_ratio = .3;
    return body;
  }

  /// Largest difference of a displacement from a given field over all nodes.
  inline double distance(const FiniteElementBody &body, const Eigen::VectorXd &displacement,
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
  inline void refine_towards(FiniteElementBody &body, const Vector2 &own_point, const unsigned int passes)
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
  inline Eigen::VectorXd untouched(FiniteElementBody &body)
  {
    body.prepare();
    return body.displacement(Eigen::VectorXd::Zero(body.trace_size()), 0.);
  }
} // namespace abut
