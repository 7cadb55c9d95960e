// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies with free rigid motions: their generalised inverse and what they tell of their motions.
#include <gtest/gtest.h>

#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  BodyDescription floating_plate()
  {
    auto body = make_body("rectangle", {2., 1.}, {{8, 4}});
    body.name = "plate";
    body.young_modulus = 100.;
    body.poisson_ratio = .3;
    return body;
  }

  /// Nodal forces on the top that sum to zero, with zero moment about any point.
  Eigen::VectorXd balanced_forces(const FiniteElementBody &body)
  {
    const Trace &side = body.contact_sides()[0];
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
    for (std::size_t i = 0; i < side.n_nodes(); ++i)
    {
      const double x = side.node_points()[i].x();
      for (const auto &[place, value] : {std::pair(.5, 1.), {1., -2.}, {1.5, 1.}})
        if (std::abs(x - place) < 1e-12)
          forces[2 * static_cast<Index>(i) + 1] = value;
    }
    return forces;
  }
} // namespace

TEST(ElasticityFloating, BalancedForcesDeformAFreeBodyAsASupportedOne)
{
  auto description = floating_plate();
  FiniteElementBody floating(description, {"top"});
  floating.prepare();
  EXPECT_EQ(floating.free_rigid_motions().size(), 3u);
  set_conditions(description, "(0, 0): displacement: 0, 0; (2, 0): displacement y: 0"); // reactions vanish
  FiniteElementBody supported(description, {"top"});
  supported.prepare();
  const Eigen::VectorXd forces = balanced_forces(floating);
  ASSERT_NEAR(forces.cwiseAbs().sum(), 4., 0.);
  const Eigen::VectorXd u = floating.deformation(forces, 0.), v = supported.deformation(forces, 0.);
  EXPECT_NEAR(floating.strain_energy(u), supported.strain_energy(v), 1e-12 * supported.strain_energy(v));
  EXPECT_NEAR(floating.strain_energy(u - v), 0., 1e-12 * supported.strain_energy(v)); // a rigid motion
  EXPECT_LT(floating.reactions(u, forces).equilibrium_residual, 1e-13);
}

TEST(ElasticityFloating, MotionsAreRigidAndLoadsTheirResultants)
{
  auto description = floating_plate();
  description.body_force = {Expression("3", {}, "test"), Expression("-5", {}, "test")};
  FiniteElementBody body(description, {"top"});
  body.prepare();
  const BodyMotions motions = body.motions();
  ASSERT_EQ(motions.loads.size(), 3);
  EXPECT_EQ(motions.stiffness.norm(), 0.);
  double x = 0., y = 0.;
  for (Index k = 0; k < 3; ++k)
  {
    const Eigen::VectorXd field = body.free_motion(Eigen::VectorXd::Unit(3, k));
    EXPECT_LT(body.strain_energy(field), 1e-12);
    EXPECT_LT((body.trace_of(field) - motions.traces.col(k)).norm(), 1e-14);
    if (motions.names[static_cast<std::size_t>(k)] == "translation along (1, 0)")
      x = motions.loads[k];
    if (motions.names[static_cast<std::size_t>(k)] == "translation along (0, 1)")
      y = motions.loads[k];
  }
  EXPECT_NEAR(x, 6., 1e-12);
  EXPECT_NEAR(y, -10., 1e-12);
}

TEST(ElasticityFloating, ARigidSideWithAGivenForceIsAMotionWithStiffness)
{
  // A column of 2 x 1, pulled along x between rollers: stiffness E / (1 - nu^2) * height / length.
  auto description = floating_plate();
  set_conditions(description,
                 "left: normal displacement: 0; bottom: normal displacement: 0; right: resultant: 7, 0");
  FiniteElementBody body(description, {"top"});
  body.prepare();
  const BodyMotions motions = body.motions();
  ASSERT_EQ(motions.loads.size(), 1);
  EXPECT_NEAR(motions.stiffness(0, 0), 100. / .91 / 2., 1e-11);
  EXPECT_NEAR(motions.loads[0], 7., 1e-12);
  EXPECT_EQ(body.rigid_side_displacement(Eigen::VectorXd::Constant(1, .3)), .3);
  const double delta = motions.loads[0] / motions.stiffness(0, 0);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(body.trace_size());
  EXPECT_NEAR(body.rigid_side_force(body.deformation(none, delta), none), 7., 1e-12);
}
