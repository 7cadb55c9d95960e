// SPDX-License-Identifier: LGPL-2.1-or-later
// Changing a body's mesh: what happens to fields, counters and numberings.
#include <abut/bodies/finite_elements/nodes.h>

#include "finite_elements_testing.h"
#include <random>

using namespace abut;

namespace
{
  BodyDescription turned_plate(const Variant &variant)
  {
    auto body = make_body("rectangle", {3., 2.}, {{3, 2}});
    body.cell_type = variant.type;
    body.degree = variant.degree;
    body.placement = Placement(1., variant.degree == 2, 25., Vector2(2., 1.));
    set_conditions(body, "left: displacement: 0, 0");
    return body;
  }

  CellMarks random_marks(const FiniteElementBody &body, std::mt19937 &random, const double split,
                         const double merged)
  {
    std::uniform_real_distribution<double> number(0., 1.);
    CellMarks marks = no_marks(body.space().mesh().triangulation);
    for (std::size_t i = 0; i < marks.refine.size(); ++i)
    {
      marks.refine[i] = number(random) < split;
      marks.coarsen[i] = !marks.refine[i] && number(random) < merged;
    }
    return marks;
  }

  Eigen::VectorXd random_field(const Space &space, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    return space.hanging_node_expansion() *
           Eigen::VectorXd::NullaryExpr(space.n_dofs(), [&] { return number(random); });
  }

  Eigen::VectorXd nodal_values(const Space &space, const std::function<Vector2(const Vector2 &)> &field)
  {
    Eigen::VectorXd values(space.n_dofs());
    const Nodes nodes = all_nodes(space);
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      for (unsigned int c = 0; c < 2; ++c)
        values[nodes.dofs[i][c]] = field(nodes.places[i])[c];
    return values;
  }

  /// A polynomial that the element of a degree holds: (x^p + y, x y^(p - 1) - y^p) about (2, 1).
  std::function<Vector2(const Vector2 &)> polynomial(const unsigned int degree)
  {
    return [degree](const Vector2 &point) {
      const double x = point.x() - 2., y = point.y() - 1.;
      return Vector2(std::pow(x, degree) + y, x * std::pow(y, degree - 1) - std::pow(y, degree));
    };
  }

  /// int |u|^2, which knows the field in all points.
  double integral_of_square(const Space &space, const Eigen::VectorXd &field)
  {
    double sum = 0.;
    visit_gradients(space, space.quadrature(), field,
                    [&](const Vector2 &, const double weight, const Vector2 &u, const Eigen::Matrix2d &) {
                      sum += weight * u.squaredNorm();
                    });
    return sum;
  }

  void expect_a_conforming_field(const Space &space, const Eigen::VectorXd &field)
  {
    ASSERT_EQ(field.size(), space.n_dofs());
    EXPECT_LT((space.hanging_node_expansion() * field - field).cwiseAbs().maxCoeff(), 1e-13);
  }

  /// Compares two fields where both have a node; returns how often that is so.
  std::size_t expect_same_values(const Nodes &nodes, const Eigen::VectorXd &field, const Nodes &other_nodes,
                                 const Eigen::VectorXd &other_field)
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < nodes.places.size(); ++i)
      for (std::size_t j = 0; j < other_nodes.places.size(); ++j)
        if ((nodes.places[i] - other_nodes.places[j]).norm() < 1e-9)
        {
          ++n;
          for (unsigned int c = 0; c < 2; ++c)
            EXPECT_NEAR(field[nodes.dofs[i][c]], other_field[other_nodes.dofs[j][c]], 1e-12);
        }
    return n;
  }

  /// The jump of a field across the edges between cells, from its values at points of both sides.
  double largest_jump(const Space &space, const Eigen::VectorXd &field)
  {
    const auto &fe = space.dof_handler().get_fe();
    const auto value_in = [&](const auto &cell, const dealii::Point<2> &point) {
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      const auto unit = space.mapping().transform_real_to_unit_cell(cell, point);
      Vector2 u = Vector2::Zero();
      for (unsigned int i = 0; i < dofs.size(); ++i)
        u[fe.system_to_component_index(i).first] +=
            field[static_cast<Eigen::Index>(dofs[i])] * fe.shape_value(i, unit);
      return u;
    };
    double largest = 0.;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->is_active())
          for (const double s : {.1, .37, .8})
          {
            const dealii::Point<2> point(cell->face(f)->vertex(0) +
                                         s * (cell->face(f)->vertex(1) - cell->face(f)->vertex(0)));
            largest = std::max(largest, (value_in(cell, point) - value_in(cell->neighbor(f), point)).norm());
          }
    return largest;
  }
} // namespace

TEST(ElasticityAdapt, FieldsAreContinuousWhereNodesHang)
{
  for (const Variant &variant : variants)
  {
    std::mt19937 random(1);
    FiniteElementBody body(turned_plate(variant), {});
    for (int pass = 0; pass < 4; ++pass)
      body.adapt(random_marks(body, random, .3, 0.), {});
    ASSERT_TRUE(body.space().has_hanging_nodes());
    const Eigen::VectorXd field = random_field(body.space(), random);
    EXPECT_GT(field.norm(), 1.);
    EXPECT_LT(largest_jump(body.space(), field), 1e-11) << variant.degree;
    EXPECT_LT((body.space().hanging_node_expansion() * field - field).norm(), 1e-12);
  }
}

TEST(ElasticityAdapt, PolynomialsAreCarriedOver)
{
  for (const Variant &variant : variants)
  {
    std::mt19937 random(2);
    FiniteElementBody body(turned_plate(variant), {});
    const auto exact = polynomial(variant.degree);
    std::vector<Eigen::VectorXd> fields{nodal_values(body.space(), exact),
                                        Eigen::VectorXd::Ones(body.space().n_dofs())};
    for (int pass = 0; pass < 5; ++pass)
    {
      CellMarks marks = random_marks(body, random, .3, .6);
      if (pass == 2) // cells that are split more than once
      {
        const dealii::Point<2> corner = body.space().mesh().triangulation.get_vertices()[0];
        marks.gradings = {{{corner[0], corner[1]}, 3}};
      }
      fields = body.adapt(marks, fields);
      EXPECT_LT(distance(body, fields[0], exact), 1e-12) << variant.degree << " " << pass;
      EXPECT_LT((fields[1].array() - 1.).abs().maxCoeff(), 1e-13);
    }
  }
}

TEST(ElasticityAdapt, SplittingAllAndMergingAllLeavesFieldsAndMeshAsTheyWere)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    std::mt19937 random(3);
    FiniteElementBody body(turned_plate({CellType::quadrilaterals, degree}), {});
    body.adapt(random_marks(body, random, .4, 0.), {});
    const Eigen::VectorXd field = random_field(body.space(), random);
    const double before = integral_of_square(body.space(), field);
    const Nodes old_nodes = free_nodes(body.space());
    const std::size_t n = body.space().mesh().triangulation.n_active_cells();
    auto fields = body.adapt({std::vector<bool>(n, true), std::vector<bool>(n, false), {}}, {field});
    EXPECT_NEAR(integral_of_square(body.space(), fields[0]), before, 1e-12 * before);
    ASSERT_EQ(body.space().mesh().triangulation.n_active_cells(), 4 * n);
    fields = body.adapt({std::vector<bool>(4 * n, false), std::vector<bool>(4 * n, true), {}}, fields);
    ASSERT_EQ(body.space().mesh().triangulation.n_active_cells(), n);
    EXPECT_NEAR(integral_of_square(body.space(), fields[0]), before, 1e-12 * before);
    // The unknowns may have other numbers.
    const Nodes nodes = free_nodes(body.space());
    EXPECT_EQ(nodes.places.size(), old_nodes.places.size());
    EXPECT_EQ(expect_same_values(nodes, fields[0], old_nodes, field), nodes.places.size());
  }
}

TEST(ElasticityAdapt, RefiningChangesNoField)
{
  for (const Variant &variant : variants)
  {
    std::mt19937 random(4);
    FiniteElementBody body(turned_plate(variant), {});
    Eigen::VectorXd field = random_field(body.space(), random);
    const double before = integral_of_square(body.space(), field);
    const Nodes old_nodes = all_nodes(body.space());
    const Eigen::VectorXd old_field = field;
    for (int pass = 0; pass < 10; ++pass)
    {
      // Fewer and fewer, of more and more cells.
      field = body.adapt(random_marks(body, random, .5 / (1. + pass), 0.), {field})[0];
      expect_a_conforming_field(body.space(), field);
      EXPECT_NEAR(integral_of_square(body.space(), field), before, 1e-11 * before)
          << variant.degree << " " << pass;
    }
    EXPECT_LT(largest_jump(body.space(), field), 1e-11);
    const Nodes nodes = all_nodes(body.space());
    // The initial vertices at least are nodes still.
    EXPECT_GE(expect_same_values(nodes, field, old_nodes, old_field), 12u);
  }
}

TEST(ElasticityAdapt, MergingKeepsTheValuesAtRemainingNodes)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    std::mt19937 random(5);
    FiniteElementBody body(turned_plate({CellType::quadrilaterals, degree}), {});
    std::vector<Eigen::VectorXd> fields{random_field(body.space(), random)};
    for (int pass = 0; pass < 10; ++pass)
    {
      fields = body.adapt(random_marks(body, random, .12, .8), fields);
      expect_a_conforming_field(body.space(), fields[0]);
      EXPECT_LT(largest_jump(body.space(), fields[0]), 1e-11);
    }
    // Fresh values, so that the merging alone is seen.
    fields[0] = random_field(body.space(), random);
    const Nodes old_nodes = all_nodes(body.space());
    const std::size_t n = body.space().mesh().triangulation.n_active_cells();
    const Eigen::VectorXd merged =
        body.adapt({std::vector<bool>(n, false), std::vector<bool>(n, true), {}}, fields)[0];
    EXPECT_LT(body.space().mesh().triangulation.n_active_cells(), n);
    expect_a_conforming_field(body.space(), merged);
    const Nodes nodes = free_nodes(body.space());
    EXPECT_GE(expect_same_values(nodes, merged, old_nodes, fields[0]), 12u);
  }
}

TEST(ElasticityAdapt, NoTwoFreeNodesShareAPlace)
{
  // With degree 2 a hanging vertex lies where the coarse edge's middle node does; only that one is free.
  for (const Variant &variant : variants)
  {
    FiniteElementBody body(turned_plate(variant), {});
    refine_towards(body, {1.4, 1.2}, 3);
    const auto shared_places = [](const Nodes &nodes) {
      std::size_t n = 0;
      for (std::size_t i = 0; i < nodes.places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          n += (nodes.places[i] - nodes.places[j]).norm() < 1e-9;
      return n;
    };
    EXPECT_EQ(shared_places(free_nodes(body.space())), 0u);
    EXPECT_EQ(shared_places(all_nodes(body.space())) > 0, variant.degree == 2);
  }
}

TEST(ElasticityAdapt, EverythingBelongsToTheNewMesh)
{
  for (const Variant &variant : variants)
  {
    FiniteElementBody body(turned_plate(variant), {"top", "right"});
    body.prepare();
    const std::size_t n_nodes = body.contact_sides()[0].n_nodes();
    const double length = body.contact_sides()[0].length();
    refine_towards(body, {3., 2.}, 2);
    EXPECT_EQ(body.counters().meshes, 3u);
    EXPECT_EQ(body.counters().assemblies, 1u);
    EXPECT_GT(body.contact_sides()[0].n_nodes(), n_nodes);
    EXPECT_NEAR(body.contact_sides()[0].length(), length, 1e-13);
    EXPECT_EQ(body.trace_size(), static_cast<Eigen::Index>(2 * (body.contact_sides()[0].n_nodes() +
                                                                body.contact_sides()[1].n_nodes())));
    for (const Trace &side : body.contact_sides())
      for (const auto &dofs : side.node_dofs())
        EXPECT_FALSE(body.space().is_constrained(dofs[0]) || body.space().is_constrained(dofs[1]));
    const Eigen::VectorXd trace = Eigen::VectorXd::LinSpaced(body.trace_size(), 0., 1.);
    EXPECT_EQ(body.trace_of(body.extended_by_zero(trace)).size(), trace.size());
    body.prepare();
    EXPECT_EQ(body.counters().assemblies, 2u);
    EXPECT_EQ(body.counters().factorisations, 2u);
    EXPECT_TRUE(body.respond(trace).allFinite());
  }
}
