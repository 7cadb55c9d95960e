// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary against finite elements: fields that both hold exactly, fields that they do not.
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/side_load.h>

#include "boundary_elements_testing.h"

using namespace abut;

namespace
{
  /// Strains .02, .04, hence stresses .13, .17 without shear, with one of several sets of supports.
  const std::string uniform_stress_conditions[] = {
      "left: displacement: " + linear_formulas +
          "; right: traction: 0.13, 0; bottom: traction: 0, -0.17; "
          "top: pressure: -0.17",
      "left: displacement x: 1e-2*(1+2*x-y); bottom: displacement y: 1e-2*(3+x+4*y); "
      "right: traction: 0.13, 0; top: traction: 0, 0.17",
      "right: displacement: " + linear_formulas + "; left: displacement: " + linear_formulas +
          "; bottom: traction: 0, -0.17; top: pressure: -0.17"};

  Eigen::Matrix2d uniform_stress(const Vector2 &)
  {
    return Eigen::Vector2d(.13, .17).asDiagonal();
  }

  /// s_xx = y, u = (.35 x y, -.075 y^2 - .175 x^2): held on the left, pulled and pressed on the right.
  const std::string bending_conditions =
      "left: displacement: 0.35*x*y, -0.075*y^2-0.175*x^2; right: traction: y, 0";
  Eigen::Matrix2d bending_stress(const Vector2 &own)
  {
    return Eigen::Vector2d(own.y(), 0.).asDiagonal();
  }

  Eigen::VectorXd deformation_of(const FiniteElementBody &body)
  {
    return body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.);
  }
} // namespace

TEST(AdaptationFEBE, EstimatesNothingForALinearDisplacement)
{
  for (const Variant &variant : variants)
    for (const std::string &conditions : uniform_stress_conditions)
      for (const BoundarySolution kind : all_boundary_solutions)
      {
        BodyDescription description = turned_plate(variant.type, variant.degree, 1.5);
        set_conditions(description, conditions);
        FiniteElementBody body(description, {});
        refine_towards(body, {1.1, .9}, 2);
        refine_towards(body, {3., 2.}, 2);
        ASSERT_TRUE(body.space().has_hanging_nodes());
        const CellErrors errors = estimate(body, kind);
        const std::string name = name_of(kind) + ", " + name_of(variant) + ": " + conditions;
        EXPECT_NEAR(errors.stress_norm, std::sqrt((.13 * .13 + .17 * .17 + .09 * .09) * 13.5), 1e-4) << name;
        EXPECT_LT(errors.stress.norm(), accuracy(kind) * errors.stress_norm) << name;
        EXPECT_LT(errors.energy.norm(), accuracy(kind) * errors.energy_norm) << name;
        const StressErrors found = stress_errors(body, deformation_of(body), errors, uniform_stress);
        EXPECT_LT(found.boundary_elements, accuracy(kind)) << name;
      }
}

TEST(AdaptationFEBE, IsExactInBendingFromDegreeTwoOn)
{
  for (const Variant &variant : variants)
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      if (variant.degree == 1)
        continue;
      BodyDescription description = turned_plate(variant.type, variant.degree, 1.);
      set_conditions(description, bending_conditions);
      FiniteElementBody body(description, {});
      refine_towards(body, {3., 2.}, 2);
      const CellErrors errors = estimate(body, kind);
      const StressErrors found = stress_errors(body, deformation_of(body), errors, bending_stress);
      EXPECT_LT(found.finite_elements, 1e-10);
      EXPECT_LT(found.boundary_elements, accuracy(kind)) << name_of(kind) << ", " << name_of(variant);
    }
}

TEST(AdaptationFEBE, IsBetterThanFiniteElementsOfDegreeOne)
{
  for (const CellType type : {CellType::quadrilaterals, CellType::triangles})
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      BodyDescription description = turned_plate(type, 1, 1.);
      description.cells = {{12, 8}};
      set_conditions(description, bending_conditions);
      FiniteElementBody body(description, {});
      const CellErrors errors = estimate(body, kind);
      const StressErrors found = stress_errors(body, deformation_of(body), errors, bending_stress);
      EXPECT_LT(found.boundary_elements, .5 * found.finite_elements) << name_of(kind);
      EXPECT_NEAR(errors.stress.norm() / errors.stress_norm, found.finite_elements,
                  found.boundary_elements * 1.1);
    }
}

TEST(AdaptationFEBE, TheLargestErrorsAreAtAKink)
{
  const std::string formulas = "0, 0.01*abs(x-1.2)";
  for (const Variant &variant : variants)
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      BodyDescription description = turned_plate(variant.type, variant.degree, 1.);
      description.cells = {{10, 6}};
      description.grading = {{1., 1.}};
      set_conditions(description, displaced_sides({"left", "right", "top", "bottom"}, formulas));
      FiniteElementBody body(description, {});
      const CellErrors errors = estimate(body, kind);
      EXPECT_GT(errors.stress.norm(), .01 * errors.stress_norm);
      Eigen::Index largest;
      errors.stress.maxCoeff(&largest);
      for (const auto &cell : body.space().mesh().triangulation.active_cell_iterators())
        if (cell->active_cell_index() == static_cast<unsigned int>(largest))
        {
          const Vector2 own =
              description.placement.point_to_own(Vector2(cell->center()[0], cell->center()[1]));
          EXPECT_LT(std::abs(own.x() - 1.2), .31) << name_of(kind) << " " << name_of(variant);
          EXPECT_GT(std::abs(own.y() - 1.), .6) << name_of(kind) << " " << name_of(variant);
        }
    }
}

TEST(AdaptationFEBE, AnswersTheContactTraction)
{
  for (const Variant &variant : variants)
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      BodyDescription description = turned_plate(variant.type, variant.degree, 1.);
      set_conditions(description, "left: normal displacement: 0; bottom: normal displacement: 0");
      FiniteElementBody body(description, {"top"});
      refine_towards(body, {3., 2.}, 2);
      body.prepare();
      Eigen::VectorXd load = Eigen::VectorXd::Zero(body.space().n_dofs());
      add_traction(body.contact_sides()[0], parse_conditions("top: pressure: 0.3", {}, "test")[0],
                   description.placement, load);
      const Eigen::VectorXd forces = body.trace_of(load), deformation = body.deformation(forces, 0.);
      const CellErrors errors = FEBEIndicator(kind).estimate({body, deformation, forces});
      const auto exact = [](const Vector2 &) -> Eigen::Matrix2d {
        return Eigen::Vector2d(0., -.3).asDiagonal();
      };
      EXPECT_LT(stress_errors(body, deformation, errors, exact).boundary_elements, accuracy(kind))
          << name_of(kind) << ", " << name_of(variant);
    }
}

TEST(AdaptationFEBE, TakesOffAUniformForce)
{
  // A column between rollers, its stress linear in y, g = .7, H = 2: less that of the force it is uniform.
  for (const Variant &variant : variants)
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      if (variant.degree == 1 && kind == BoundarySolution::finite_element_trace)
        continue; // its reactions are those of a stress that finite elements of degree 1 do not hold
      BodyDescription description = turned_plate(variant.type, variant.degree, 1.);
      description.placement = Placement(1., false, 90., Vector2(2., 1.));
      description.body_force = {Expression("0", {}, "test"), Expression("-0.7", {}, "test")};
      set_conditions(description, "left: normal displacement: 0; right: normal displacement: 0; "
                                  "bottom: normal displacement: 0");
      FiniteElementBody body(description, {});
      const CellErrors errors = estimate(body, kind);
      const auto exact = [](const Vector2 &own) -> Eigen::Matrix2d {
        const double s = -.7 * (2. - own.y());
        return Eigen::Vector2d(.3 / .7 * s, s).asDiagonal();
      };
      const StressErrors found = stress_errors(body, deformation_of(body), errors, exact);
      EXPECT_LT(found.boundary_elements, accuracy(kind)) << name_of(kind) << ", " << name_of(variant);
    }
}

TEST(AdaptationFEBE, ReproducesAFreeColumnUnderItsOwnWeight)
{
  // s_yy = -g (H - y) alone, g = .7, H = 2; u is quadratic.
  for (const Variant &variant : variants)
    for (const BoundarySolution kind : all_boundary_solutions)
    {
      if (variant.degree == 1)
        continue;
      BodyDescription description = turned_plate(variant.type, variant.degree, 1.);
      description.body_force = {Expression("0", {}, "test"), Expression("-0.7", {}, "test")};
      set_conditions(description,
                     "bottom: displacement: 0.7*0.15*(2-y)*x, 0.7*(-0.35*(2*y-0.5*y^2)+0.075*x^2)");
      FiniteElementBody body(description, {});
      refine_towards(body, {3., 2.}, 2);
      const CellErrors errors = estimate(body, kind);
      const auto exact = [](const Vector2 &own) -> Eigen::Matrix2d {
        return Eigen::Vector2d(0., -.7 * (2. - own.y())).asDiagonal();
      };
      const StressErrors found = stress_errors(body, deformation_of(body), errors, exact);
      EXPECT_LT(found.finite_elements, 1e-10);
      EXPECT_LT(found.boundary_elements, accuracy(kind)) << name_of(kind) << ", " << name_of(variant);
    }
}
