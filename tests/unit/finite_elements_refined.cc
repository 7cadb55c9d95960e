// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies with hanging nodes: patch tests, forces, rigid motions.
#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  /// Graded, turned and mirrored; its cells refined over several levels, inside and at a corner.
  BodyDescription graded_plate(const Variant &variant, const std::string &conditions)
  {
    auto body = turned_plate(variant.type, variant.degree, 1.5);
    set_conditions(body, conditions);
    return body;
  }

  void refine_several_levels(FiniteElementBody &body)
  {
    refine_towards(body, {1.1, .9}, 3);
    refine_towards(body, {3., 2.}, 3);
    ASSERT_TRUE(body.space().has_hanging_nodes());
    ASSERT_GE(body.space().mesh().triangulation.n_levels(), 4u);
  }

  const Eigen::VectorXd no_forces;
} // namespace

TEST(ElasticityRefined, LinearDisplacementsAreExact)
{
  for (const Variant &variant : variants)
  {
    const std::string conditions = displaced_sides({"left", "right", "bottom", "top"}, linear_formulas);
    const BodyDescription description = graded_plate(variant, conditions);
    FiniteElementBody body(description, {});
    refine_several_levels(body);
    const Eigen::VectorXd u = untouched(body);
    const auto exact = [&](const Vector2 &x) { return linear_field(description.placement, x); };
    EXPECT_LT(distance(body, u, exact), 1e-14) << variant.degree;
    EXPECT_LT(body.reactions(u, no_forces).equilibrium_residual, 1e-12);
  }
}

TEST(ElasticityRefined, LinearDisplacementsBelowACurvedTop)
{
  // A parabola is what cells of degree 2 and 3 follow exactly, so that there is no gap where they hang.
  for (const unsigned int degree : {2u, 3u})
  {
    BodyDescription description = graded_plate({CellType::quadrilaterals, degree},
                                               "left: displacement: 1e-2*(2*x - y), 1e-2*(x + 4*y); "
                                               "top: displacement: 1e-2*(2*x - y), 1e-2*(x + 4*y); "
                                               "right: displacement: 1e-2*(2*x - y), 1e-2*(x + 4*y); "
                                               "bottom: displacement: 1e-2*(2*x - y), 1e-2*(x + 4*y)");
    description.shape = "rectangle with curved top";
    description.top = Expression("1 + 0.2*x - 0.05*x^2", {}, "test");
    description.size = {3., 1.};
    FiniteElementBody body(description, {});
    refine_towards(body, {1.1, .7}, 3);
    ASSERT_TRUE(body.space().has_hanging_nodes());
    const Eigen::VectorXd u = untouched(body);
    EXPECT_LT(distance(body, u,
                       [&](const Vector2 &x) {
                         const Vector2 own = description.placement.point_to_own(x);
                         return Vector2(1.5e-2 * description.placement.direction_to_world(Vector2(
                                                     2. * own.x() - own.y(), own.x() + 4. * own.y())));
                       }),
              1e-14)
        << degree;
  }
}

TEST(ElasticityRefined, UniaxialStrainByRollersTractionOrARigidSideIsExact)
{
  // eps_yy = -5e-3: sigma_yy = -3.5 * 5e-3, sigma_xx = -1.5 * 5e-3; mu = 1, lambda = 1.5. Lengths are 1.5
  // times those of the own frame.
  for (const Variant &variant : variants)
    for (const std::string top : {"normal displacement: -1e-2", "displacement: 0, -1e-2",
                                  "traction: 0, -0.0175", "pressure: 0.0175", "resultant: -0.07875"})
    {
      const BodyDescription description =
          graded_plate(variant, "left: normal displacement: 0; right: normal displacement: 0; "
                                "bottom: normal displacement: 0; top: " +
                                    top);
      FiniteElementBody body(description, {});
      refine_several_levels(body);
      body.prepare();
      // A rigid side goes along the outward normal.
      const Eigen::VectorXd u =
          body.displacement(Eigen::VectorXd::Zero(0), body.resultant() ? -1e-2 * 1.5 : 0.);
      const Vector2 up = description.placement.direction_to_world(Vector2::UnitY());
      const Vector2 right = description.placement.direction_to_world(Vector2::UnitX());
      EXPECT_LT(distance(body, u,
                         [&](const Vector2 &x) {
                           return Vector2(-7.5e-3 * description.placement.point_to_own(x).y() * up);
                         }),
                1e-13)
          << top << variant.degree;
      EXPECT_NEAR(body.strain_energy(u), .5 * 3.5 * 5e-3 * 5e-3 * 6. * 2.25, 1e-14);
      const Reactions reactions = body.reactions(u, no_forces);
      EXPECT_LT(reactions.equilibrium_residual, 1e-12) << top;
      EXPECT_LT((reactions.by_boundary.at("bottom") - .07875 * up).norm(), 1e-13);
      EXPECT_LT((reactions.by_boundary.at("left") - 1.5 * 5e-3 * 3. * right).norm(), 1e-13);
      EXPECT_LT((reactions.by_boundary.at("right") + 1.5 * 5e-3 * 3. * right).norm(), 1e-13);
      const double resultant = body.resultant() ? body.resultant()->force : 0.;
      EXPECT_NEAR(body.rigid_side_force(u, no_forces), resultant, 1e-13);
    }
}

TEST(ElasticityRefined, ReactionsBalanceBodyForcesTractionsAndContactForces)
{
  for (const Variant &variant : variants)
  {
    BodyDescription description = graded_plate(
        variant, "bottom: normal displacement: 0; left: normal displacement: 0; top: traction: 0.1*x, -x^2");
    description.body_force = {Expression("0.3*x", {}, "test"), Expression("-0.5", {}, "test")};
    FiniteElementBody body(description, {"top", "right"});
    refine_several_levels(body);
    body.prepare();
    const Eigen::VectorXd forces = Eigen::VectorXd::LinSpaced(body.trace_size(), -1., 2.).array().sin();
    const Eigen::VectorXd u = body.displacement(forces, 0.);
    const Reactions reactions = body.reactions(u, forces);
    // The traction on lengths of 1.5, the body force on an area of 2.25 times that of the own frame:
    // int (0.1 x, -x^2) dx = (.45, -9), int (0.3 x, -.5) = (2.7, -3).
    const Vector2 applied =
        description.placement.direction_to_world(Vector2(1.5 * .45 + 2.25 * 2.7, -1.5 * 9. - 2.25 * 3.));
    EXPECT_LT((reactions.applied - applied).norm(), 1e-12) << variant.degree;
    Vector2 sum = applied;
    for (Eigen::Index i = 0; i < forces.size(); i += 2)
      sum += forces.segment<2>(i);
    for (const auto &entry : reactions.by_boundary)
      sum += entry.second;
    EXPECT_LT(sum.norm(), 1e-10) << variant.degree;
    EXPECT_LT(reactions.equilibrium_residual, 1e-12) << variant.degree;
    EXPECT_LT(reactions.moment_residual, 1e-12) << variant.degree;

    // Maxwell and Betti, and the work of the contact forces.
    const Eigen::VectorXd change = u - body.displacement(Eigen::VectorXd::Zero(forces.size()), 0.);
    const Eigen::VectorXd response = body.respond(forces), others = forces.reverse();
    EXPECT_NEAR(others.dot(response), forces.dot(Eigen::VectorXd(body.respond(others))), 1e-10);
    EXPECT_NEAR(.5 * forces.dot(response), body.strain_energy(change), 1e-10);
    EXPECT_LT((body.trace_of(change) - response).norm(), 1e-11 * response.norm());
  }
}

TEST(ElasticityRefined, ARigidMotionMakesNoStress)
{
  for (const Variant &variant : variants)
  {
    // A turn by 1e6 and a shift, far more than the body's size.
    const BodyDescription description = graded_plate(
        variant, "left: displacement: 3e6 - 1e6*y, 1e6*x; right: displacement: 3e6 - 1e6*y, 1e6*x");
    FiniteElementBody body(description, {});
    refine_several_levels(body);
    body.prepare();
    const Eigen::VectorXd deformation = body.deformation(no_forces, 0.);
    EXPECT_LT(deformation.cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT(distance(body, deformation + body.rigid_motion(0.),
                       [&](const Vector2 &x) {
                         const Vector2 own = description.placement.point_to_own(x);
                         return Vector2(1.5e6 * description.placement.direction_to_world(
                                                    Vector2(3. - own.y(), own.x())));
                       }),
              1e-8)
        << variant.degree;
    EXPECT_LT(std::sqrt(body.strain_energy(deformation)), 1e-8);
  }
}

TEST(ElasticityRefined, ConditionsAtVerticesSurvive)
{
  for (const Variant &variant : variants)
  {
    // The middle of the body is an initial vertex.
    auto description = graded_plate(variant, "(1.5, 1): displacement: 0.3, 0.2; (3, 2): displacement y: 0.2; "
                                             "left: traction: -0.5, 0; right: traction: 0.5, 0");
    description.grading = {{1., 1.}};
    description.cells = {{2, 2}};
    FiniteElementBody body(description, {});
    // Towards a place beside the middle, so that it is at the border between coarse and fine cells too.
    refine_towards(body, {1.9, 1.05}, 4);
    EXPECT_TRUE(body.free_rigid_motions().empty());
    const Eigen::VectorXd u = untouched(body);
    // Plane strain under sigma_xx = .5: eps_xx = (1 - nu^2)/E sigma_xx, eps_yy = -nu (1 + nu)/E sigma_xx; no
    // turn; y is fixed where x is 1.5 and 3, at different heights, so that a turn makes up for eps_yy.
    const double xx = .91 / 2.6 * .5, yy = -.39 / 2.6 * .5, turn = -yy / 1.5;
    EXPECT_LT(distance(body, u,
                       [&](const Vector2 &x) {
                         const Vector2 d = description.placement.point_to_own(x) - Vector2(1.5, 1.);
                         return Vector2(1.5 *
                                        description.placement.direction_to_world(Vector2(
                                            .3 + xx * d.x() - turn * d.y(), .2 + yy * d.y() + turn * d.x())));
                       }),
              1e-13)
        << variant.degree;
  }
}

TEST(ElasticityRefined, ARingUnderPressureConvergesAndIsInBalance)
{
  // Lame: u_r = (1 + nu)/E p a^2/(b^2 - a^2) ((1 - 2 nu) r + b^2/r).
  const double a = 1., b = 2., pressure = .3;
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    auto description = make_body("quarter ring", {a, b}, {{4, 3}});
    description.degree = degree;
    description.young_modulus = 2.6;
    description.poisson_ratio = .3;
    set_conditions(description, "left: normal displacement: 0; bottom: normal displacement: 0; "
                                "inner: pressure: 0.3");
    FiniteElementBody body(description, {"outer"});
    std::vector<double> errors;
    for (int mesh = 0; mesh < 3; ++mesh)
    {
      if (mesh == 0)
        refine_towards(body, {1., 0.}, 2);
      else
      {
        CellMarks all = no_marks(body.space().mesh().triangulation);
        all.refine.flip();
        body.adapt(all, {});
      }
      ASSERT_TRUE(body.space().has_hanging_nodes());
      const Eigen::VectorXd u = untouched(body);
      errors.push_back(distance(body, u, [&](const Vector2 &x) {
        const double r = x.norm();
        return Vector2(1.3 / 2.6 * pressure * a * a / (b * b - a * a) * (.4 * r + b * b / r) * x / r);
      }));
      const Reactions reactions =
          body.reactions(body.deformation(Eigen::VectorXd::Zero(body.trace_size()), 0.),
                         Eigen::VectorXd::Zero(body.trace_size()));
      EXPECT_LT(reactions.equilibrium_residual, 1e-12);
    }
    EXPECT_GT(errors[1] / errors[2], .8 * std::pow(2., degree + 1.)) << degree;
  }
}

TEST(ElasticityRefined, ADiscPressedBetweenItsSidesIsInBalance)
{
  for (const unsigned int degree : {1u, 2u, 3u})
  {
    auto description = make_body("quarter disc", {2.}, {{4, 1}});
    description.degree = degree;
    description.placement = Placement(1., false, 30., Vector2(1., 2.));
    set_conditions(description, "left: normal displacement: 0; bottom: normal displacement: 0; "
                                "outer: pressure: 0.3*x");
    FiniteElementBody body(description, {});
    refine_towards(body, {2., 0.}, 4);
    ASSERT_TRUE(body.space().has_hanging_nodes());
    const Reactions reactions = body.reactions(untouched(body), no_forces);
    EXPECT_LT(reactions.equilibrium_residual, 1e-12);
    // -int p n: n = (cos t, sin t), x = 2 cos t, r = 2: .3 * 4 * (pi/4, 1/2).
    const Vector2 applied = description.placement.direction_to_world(Vector2(-.3 * pi, -.6));
    EXPECT_LT((reactions.applied - applied).norm(), 1e-5);
  }
}
