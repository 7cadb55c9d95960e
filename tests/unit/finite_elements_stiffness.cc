// SPDX-License-Identifier: LGPL-2.1-or-later
// Material law, stiffness matrix, patch tests.
#include <abut/bodies/finite_elements/assembly.h>
#include <abut/bodies/finite_elements/nodes.h>

#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  /// Curved top, graded cells, turned and mirrored.
  BodyDescription distorted(const Variant &variant)
  {
    auto body = make_body("rectangle with curved top", {3., 1.}, {{4, 3}});
    body.top = Expression("1 + 0.2*x - 0.05*x^2", {}, "test");
    body.grading = {{2., .5}};
    body.cell_type = variant.type;
    body.degree = variant.degree;
    body.placement = Placement(1.5, true, 25., Vector2(2., 1.));
    body.young_modulus = 7.;
    body.poisson_ratio = .3;
    return body;
  }
} // namespace

TEST(ElasticityMaterial, LameConstantsAndStress)
{
  const Material material{2.6, .3}; // mu = 1, lambda = 1.5
  EXPECT_NEAR(material.mu(), 1., 1e-15);
  EXPECT_NEAR(material.lambda(), 1.5, 1e-15);
  Eigen::Matrix2d gradient;
  gradient << .2, .5, -.1, .4;
  const Stress stress = material.stress(gradient);
  EXPECT_NEAR(stress.xx, 1.5 * .6 + 2. * .2, 1e-15);
  EXPECT_NEAR(stress.yy, 1.5 * .6 + 2. * .4, 1e-15);
  EXPECT_NEAR(stress.xy, .4, 1e-15);
  EXPECT_NEAR(stress.zz, .3 * (stress.xx + stress.yy), 1e-15);
}

TEST(ElasticityMaterial, VonMises)
{
  EXPECT_NEAR((Stress{3., 0., 0., 0.}).von_mises(), 3., 1e-15);
  EXPECT_NEAR((Stress{0., 0., 2., 0.}).von_mises(), 2. * std::sqrt(3.), 1e-15);
  EXPECT_NEAR((Stress{-5., -5., 0., -5.}).von_mises(), 0., 1e-15);
  EXPECT_NEAR((Stress{1., 2., 3., 4.}).von_mises(), std::sqrt(.5 * (1. + 4. + 9.) + 27.), 1e-14);
}

TEST(ElasticityStiffness, IsSymmetricWithTheRigidModesInItsKernel)
{
  for (const Variant &variant : variants)
  {
    const BodyDescription body = distorted(variant);
    const Space space(make_mesh(body), body.degree);
    const Eigen::SparseMatrix<double> stiffness =
        assemble_stiffness(space, CellMaterials(Material{7., .3}), false);
    const Eigen::SparseMatrix<double> transposed = stiffness.transpose();
    EXPECT_EQ((stiffness - transposed).norm(), 0.);

    Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(space.n_dofs(), 3);
    const Nodes nodes = all_nodes(space);
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
    {
      modes(nodes.dofs[i][0], 0) = modes(nodes.dofs[i][1], 1) = 1.;
      modes(nodes.dofs[i][0], 2) = -nodes.places[i].y();
      modes(nodes.dofs[i][1], 2) = nodes.places[i].x();
    }
    const double size = Eigen::VectorXd(stiffness.diagonal()).maxCoeff();
    EXPECT_LT((stiffness * modes).cwiseAbs().maxCoeff(), 1e-12 * size) << variant.degree;
  }
}

TEST(ElasticityStiffness, ReproducesLinearDisplacementsOnDistortedCells)
{
  for (const Variant &variant : variants)
  {
    BodyDescription description = distorted(variant);
    set_conditions(description, displaced_sides({"left", "right", "bottom", "top"}, linear_formulas));
    FiniteElementBody body(description, {});
    const Eigen::VectorXd u = untouched(body);
    const auto exact = [&](const Vector2 &x) { return linear_field(description.placement, x); };
    EXPECT_LT(distance(body, u, exact), 1e-14) << variant.degree;
  }
}

TEST(ElasticityStiffness, ReproducesLinearDisplacementsOnDiscs)
{
  // Not for degree 3, whose inner edge nodes lie on the cubic curve while conditions are read on the quartic
  // one.
  for (unsigned int degree = 1; degree <= 2; ++degree)
  {
    auto description = make_body("disc", {2.}, {{4, 1}});
    description.degree = degree;
    set_conditions(description, "outer: displacement: 1e-2*(1 + 2*x - y), 1e-2*(3 + x + 4*y)");
    FiniteElementBody body(description, {});
    const Eigen::VectorXd u = untouched(body);
    const auto exact = [](const Vector2 &x) {
      return Vector2(1e-2 * (1. + 2. * x.x() - x.y()), 1e-2 * (3. + x.x() + 4. * x.y()));
    };
    EXPECT_LT(distance(body, u, exact), 1e-14) << degree;
  }
}

TEST(ElasticityStiffness, UniaxialStrainBetweenRollersIsExact)
{
  for (const Variant &variant : variants)
  {
    auto description = make_body("rectangle", {3., 2.}, {{4, 3}});
    description.grading = {{3., .3}};
    description.cell_type = variant.type;
    description.degree = variant.degree;
    description.young_modulus = 2.6;
    description.poisson_ratio = .3;
    description.placement = Placement(1., false, 37., Vector2(1000., -5.));
    set_conditions(description, "left: normal displacement: 0; right: normal displacement: 0; "
                                "bottom: normal displacement: 0; top: normal displacement: -1e-2");
    FiniteElementBody body(description, {});
    const Eigen::VectorXd u = untouched(body);
    const Vector2 up = description.placement.direction_to_world(Vector2::UnitY());
    const auto exact = [&](const Vector2 &x) {
      return Vector2(-5e-3 * description.placement.point_to_own(x).y() * up);
    };
    EXPECT_LT(distance(body, u, exact), 1e-14) << variant.degree;

    // sigma_yy = -(lambda + 2 mu) 5e-3 and sigma_xx = -lambda 5e-3, along the turned axes.
    EXPECT_NEAR(body.strain_energy(u), .5 * 3.5 * 5e-3 * 5e-3 * 6., 1e-15);
    const Reactions reactions = body.reactions(u, Eigen::VectorXd::Zero(0));
    const Vector2 right = description.placement.direction_to_world(Vector2::UnitX());
    EXPECT_LT((reactions.by_boundary.at("top") + 3.5 * 5e-3 * 3. * up).norm(), 1e-14);
    EXPECT_LT((reactions.by_boundary.at("bottom") - 3.5 * 5e-3 * 3. * up).norm(), 1e-14);
    EXPECT_LT((reactions.by_boundary.at("left") - 1.5 * 5e-3 * 2. * right).norm(), 1e-14);
    EXPECT_LT((reactions.by_boundary.at("right") + 1.5 * 5e-3 * 2. * right).norm(), 1e-14);
    visit_gradients(body.space(), body.space().quadrature(), u,
                    [&](const Vector2 &, double, const Vector2 &, const Eigen::Matrix2d &gradient) {
                      const Stress s = body.material().stress(gradient);
                      EXPECT_NEAR(s.xx + s.yy, -5. * 5e-3, 1e-13);
                      EXPECT_NEAR(s.zz, -1.5 * 5e-3, 1e-13);
                    });
  }
}
