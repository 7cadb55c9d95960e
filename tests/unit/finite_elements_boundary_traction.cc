// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known of the traction on a body's boundary.
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/boundary_traction.h>
#include <abut/bodies/side_load.h>

#include <deal.II/base/quadrature_lib.h>

#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  /// Turned and mirrored, refined towards the corner of right and top.
  std::unique_ptr<FiniteElementBody> loaded_body(const Variant &variant, const std::string &conditions,
                                                 const std::vector<std::string> &contact_sides = {})
  {
    auto description = make_body("rectangle", {3., 2.}, {{3, 2}});
    description.cell_type = variant.type;
    description.degree = variant.degree;
    description.placement = Placement(1.5, true, 25., Vector2(2., 1.));
    set_conditions(description, conditions);
    auto body = std::make_unique<FiniteElementBody>(description, contact_sides);
    refine_towards(*body, {3., 2.}, 3);
    return body;
  }

  using Visitor =
      std::function<void(const KnownTraction &traction, const Vector2 &own_point, const Vector2 &normal)>;

  /// At some points of all edges of a side.
  void visit_side(const FiniteElementBody &body, const std::string &side,
                  const Eigen::VectorXd &contact_forces, const Visitor &visit)
  {
    const BoundaryTraction boundary(body, contact_forces);
    const auto id = boundary_id(body.space().mesh(), side);
    const auto &fe = body.space().dof_handler().get_fe();
    dealii::FEFaceValues<2> values(body.space().mapping(), fe, dealii::QGauss<1>(3),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    unsigned int n = 0;
    for (const auto &cell : body.space().dof_handler().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() == id)
        {
          values.reinit(cell, f);
          cell->get_dof_indices(dofs);
          for (unsigned int q = 0; q < 3; ++q)
          {
            const auto p = values.quadrature_point(q);
            const auto m = values.normal_vector(q);
            visit(boundary.at(values, q, id, dofs),
                  body.description().placement.point_to_own(Vector2(p[0], p[1])), Vector2(m[0], m[1]));
            ++n;
          }
        }
    EXPECT_GT(n, 0u);
  }

  void expect_directions(const KnownTraction &traction, const std::vector<Vector2> &expected)
  {
    ASSERT_EQ(traction.directions.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_NEAR(traction.directions[i].norm(), 1., 1e-14);
      EXPECT_NEAR(std::abs(traction.directions[i].dot(expected[i])), 1., 1e-14);
    }
  }

  /// The consistent forces of pressures on the contact sides, each given by an expression.
  Eigen::VectorXd forces_of_pressures(const FiniteElementBody &body,
                                      const std::vector<std::string> &pressures)
  {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
    for (std::size_t k = 0; k < pressures.size(); ++k)
    {
      const Trace &side = body.contact_sides()[k];
      Eigen::VectorXd load = Eigen::VectorXd::Zero(body.space().n_dofs());
      add_traction(side, parse_conditions("top: pressure: " + pressures[k], {}, "test")[0],
                   body.description().placement, load);
      for (std::size_t node = 0; node < side.n_nodes(); ++node)
        for (unsigned int c = 0; c < 2; ++c)
          forces[body.trace_offset(k) + static_cast<Eigen::Index>(2 * node + c)] =
              load[side.node_dofs()[node][c]];
    }
    return forces;
  }

  const Eigen::VectorXd nothing;
  const Vector2 unit_x = Vector2::UnitX(), unit_y = Vector2::UnitY();
} // namespace

TEST(ElasticityBoundaryTraction, IsZeroOnFreeSides)
{
  for (const Variant &variant : variants)
  {
    const auto body = loaded_body(variant, "left: displacement: 0, 0");
    visit_side(*body, "top", nothing, [](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
      EXPECT_EQ(traction.value.norm(), 0.);
      expect_directions(traction, {unit_x, unit_y});
    });
  }
}

TEST(ElasticityBoundaryTraction, IsKnownAlongWhatSupportsLeaveFree)
{
  const auto body =
      loaded_body({CellType::quadrilaterals, 2}, "left: displacement: 0, 0; bottom: normal displacement: 0; "
                                                 "right: displacement x: 0; top: tangential displacement: 0");
  const Placement &placement = body->description().placement;
  const auto expect_on = [&](const std::string &side, const std::vector<Vector2> &own_directions) {
    std::vector<Vector2> directions;
    for (const Vector2 &own : own_directions)
      directions.push_back(placement.direction_to_world(own));
    visit_side(*body, side, nothing, [&](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
      EXPECT_EQ(traction.value.norm(), 0.);
      expect_directions(traction, directions);
    });
  };
  expect_on("left", {});
  expect_on("bottom", {unit_x});
  expect_on("right", {unit_y});
  expect_on("top", {unit_y});
}

TEST(ElasticityBoundaryTraction, SupportsAddUp)
{
  const auto body =
      loaded_body({CellType::triangles, 1}, "bottom: displacement x: 0; bottom: displacement y: 0; "
                                            "left: normal displacement: 0; left: displacement x: 0; "
                                            "top: resultant: 0, -1; top: traction: 0.3, 0");
  const Vector2 x = body->description().placement.direction_to_world(unit_x);
  const Vector2 y = body->description().placement.direction_to_world(unit_y);
  visit_side(*body, "bottom", nothing, [](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
    EXPECT_TRUE(traction.directions.empty());
  });
  // The same direction twice.
  visit_side(*body, "left", nothing, [&](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
    expect_directions(traction, {y});
  });
  // A rigid side carries what it must along its resultant; across it the load is what there is.
  visit_side(*body, "top", nothing, [&](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
    expect_directions(traction, {x});
    EXPECT_LT((traction.value - .3 * x).norm(), 1e-15);
  });
}

TEST(ElasticityBoundaryTraction, IsWhatLoadsPrescribe)
{
  for (const Variant &variant : variants)
  {
    const auto body =
        loaded_body(variant, "left: displacement: 0, 0; top: traction: 0.1*x, y-x^2; right: pressure: 0.2*y");
    const Placement &placement = body->description().placement;
    visit_side(*body, "top", nothing, [&](const KnownTraction &traction, const Vector2 &x, const Vector2 &) {
      const Vector2 own(.1 * x.x(), x.y() - x.x() * x.x());
      EXPECT_LT((traction.value - placement.direction_to_world(own)).norm(), 1e-13);
      expect_directions(traction, {unit_x, unit_y});
    });
    visit_side(*body, "right", nothing,
               [&](const KnownTraction &traction, const Vector2 &x, const Vector2 &normal) {
                 EXPECT_LT((traction.value + .2 * x.y() * normal).norm(), 1e-13);
                 EXPECT_LT((normal - placement.direction_to_world(unit_x)).norm(), 1e-13);
               });
  }
}

TEST(ElasticityBoundaryTraction, UniformContactPressuresAreFound)
{
  // Two sides with different pressures that share the corner towards which the mesh is refined; the pressure
  // of a load comes on top.
  for (const Variant &variant : variants)
  {
    const auto body =
        loaded_body(variant, "left: displacement: 0, 0; right: pressure: 0.25", {"top", "right"});
    const Eigen::VectorXd forces = forces_of_pressures(*body, {"0.7", "0.3"});
    visit_side(*body, "top", forces,
               [](const KnownTraction &traction, const Vector2 &, const Vector2 &normal) {
                 EXPECT_LT((traction.value + .7 * normal).norm(), 1e-12);
                 expect_directions(traction, {unit_x, unit_y});
               });
    visit_side(*body, "right", forces,
               [](const KnownTraction &traction, const Vector2 &, const Vector2 &normal) {
                 EXPECT_LT((traction.value + .55 * normal).norm(), 1e-12);
               });
    visit_side(*body, "bottom", forces, [](const KnownTraction &traction, const Vector2 &, const Vector2 &) {
      EXPECT_EQ(traction.value.norm(), 0.);
    });
  }
}

TEST(ElasticityBoundaryTraction, LinearContactPressuresAreFoundInside)
{
  // Between nodes where neighbouring edges are alike and the end is far: on the left, coarse part of the top.
  for (const Variant &variant : variants)
  {
    auto description = make_body("rectangle", {3., 2.}, {{12, 2}});
    description.cell_type = variant.type;
    description.degree = variant.degree;
    set_conditions(description, "bottom: displacement: 0, 0");
    const FiniteElementBody body(description, {"top"});
    const Eigen::VectorXd forces = forces_of_pressures(body, {"1 + 0.4*x"});
    visit_side(body, "top", forces, [](const KnownTraction &traction, const Vector2 &x, const Vector2 &) {
      if (x.x() > .25 && x.x() < 2.75)
        EXPECT_NEAR(traction.value.y(), -1. - .4 * x.x(), 1e-12);
      else // at an end by the share of the last edge that a node stands for
        EXPECT_NEAR(traction.value.y(), -1. - .4 * x.x(), .4 * .25 / 2.);
    });
  }
}
