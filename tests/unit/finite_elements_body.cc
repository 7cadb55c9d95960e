// SPDX-License-Identifier: LGPL-2.1-or-later
// One body: loads, reactions, responses of its contact sides, refusals.
#include "finite_elements_testing.h"
#include <limits>

using namespace abut;

namespace
{
  BodyDescription block(const std::string &conditions)
  {
    auto body = make_body("rectangle", {3., 2.}, {{6, 4}});
    body.degree = 2;
    body.young_modulus = 2.6;
    body.poisson_ratio = .3;
    set_conditions(body, conditions);
    return body;
  }

  void set_body_force(BodyDescription &body, const std::string &x, const std::string &y)
  {
    body.body_force = {Expression(x, {}, "test"), Expression(y, {}, "test")};
  }

  Vector2 sum_of_reactions(const Reactions &reactions)
  {
    Vector2 sum = Vector2::Zero();
    for (const auto &entry : reactions.by_boundary)
      sum += entry.second;
    return sum;
  }

  Eigen::VectorXd some_forces(const FiniteElementBody &body)
  {
    Eigen::VectorXd forces(body.trace_size());
    for (Eigen::Index i = 0; i < forces.size(); ++i)
      forces[i] = std::sin(3. * static_cast<double>(i) + 1.);
    return forces;
  }
} // namespace

TEST(ElasticityBody, ReactionsBalanceAWeight)
{
  BodyDescription description = block("bottom: displacement: 0, 0");
  description.placement = Placement(2., false, 30., Vector2(5., 6.));
  set_body_force(description, "0", "-0.5");
  FiniteElementBody body(description, {});
  const Eigen::VectorXd u = untouched(body);
  const Reactions reactions = body.reactions(u, Eigen::VectorXd());
  // Area 4 * 6; the force per volume is given along the own axes and not scaled.
  const Vector2 weight = description.placement.direction_to_world(Vector2(0., -12.));
  EXPECT_LT((reactions.applied - weight).norm(), 1e-12);
  EXPECT_LT((reactions.by_boundary.at("bottom") + weight).norm(), 1e-11);
  EXPECT_LT(reactions.equilibrium_residual, 1e-12);
}

TEST(ElasticityBody, ACoupleIsNoBalanceOfMoments)
{
  FiniteElementBody body(block(""), {"top"});
  body.prepare();
  const auto &points = body.contact_sides()[0].node_points();
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(body.trace_size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].x() == 0. || points[i].x() == 2.)
      forces[static_cast<Eigen::Index>(2 * i + 1)] = points[i].x() - 1.; // -1 and 1 on an arm of 2
  const Reactions reactions = body.reactions(Eigen::VectorXd::Zero(body.space().n_dofs()), forces);
  EXPECT_LT(reactions.equilibrium_residual, 1e-15);
  EXPECT_NEAR(reactions.moment_residual, 2. / (std::sqrt(4. + 9.) * 2.), 1e-14);
}

TEST(ElasticityBody, ReactionsBalanceTractionsPressuresAndContactForces)
{
  BodyDescription description = block("bottom: normal displacement: 0; left: normal displacement: 0; "
                                      "top: traction: 0.1*x, -x^2; right: pressure: 0.2*y");
  description.placement = Placement(1., false, -20., Vector2(1., 1.));
  FiniteElementBody body(description, {"top", "right"});
  body.prepare();
  const Eigen::VectorXd forces = some_forces(body);
  const Eigen::VectorXd u = body.displacement(forces, 0.);
  const Reactions reactions = body.reactions(u, forces);
  // int_0^3 (0.1 x, -x^2) dx and -int_0^2 0.2 y dy along x.
  const Vector2 applied = description.placement.direction_to_world(Vector2(.45 - .4, -9.));
  EXPECT_LT((reactions.applied - applied).norm(), 1e-13);
  Vector2 contact = Vector2::Zero();
  for (Eigen::Index i = 0; i < forces.size(); i += 2)
    contact += forces.segment<2>(i);
  EXPECT_LT((reactions.contact - contact).norm(), 1e-13);
  EXPECT_LT((sum_of_reactions(reactions) + applied + contact).norm(), 1e-11);
  EXPECT_LT(reactions.equilibrium_residual, 1e-12);
  // A roller's force stands on its side.
  const Vector2 x = description.placement.direction_to_world(Vector2::UnitX());
  EXPECT_NEAR(reactions.by_boundary.at("bottom").dot(x), 0., 1e-12);
  EXPECT_NEAR(reactions.by_boundary.at("left").norm(), std::abs(reactions.by_boundary.at("left").dot(x)),
              1e-12);
}

TEST(ElasticityBody, APressureOnACurvePullsNowhere)
{
  // A closed curve under uniform pressure has no resultant, and its strain is uniform: u_r = -p r (1 - 2 nu)
  // (1 + nu) / E.
  auto description = make_body("disc", {2.}, {{8, 2}});
  description.degree = 3;
  description.young_modulus = 2.6;
  description.poisson_ratio = .3;
  set_conditions(description, "outer: pressure: 0.1; (0, 0): displacement: 0, 0; (2, 0): displacement y: 0");
  FiniteElementBody body(description, {});
  EXPECT_TRUE(body.free_rigid_motions().empty());
  const Eigen::VectorXd u = untouched(body);
  EXPECT_LT(body.reactions(u, Eigen::VectorXd()).applied.norm(), 1e-14);
  EXPECT_LT(distance(body, u, [](const Vector2 &x) { return Vector2(-.1 * .4 * 1.3 / 2.6 * x); }), 1e-6);
}

TEST(ElasticityBody, RespondsAsItsDisplacementChanges)
{
  BodyDescription description = block("bottom: displacement: 0.01, 0.02; left: traction: 0.3, 0");
  FiniteElementBody body(description, {"right", "top"});
  body.prepare();
  const Eigen::VectorXd forces = some_forces(body), zero = Eigen::VectorXd::Zero(body.trace_size());
  const Eigen::VectorXd change = body.displacement(forces, 0.) - body.displacement(zero, 0.);
  const Eigen::VectorXd response = body.respond(forces),
                        untouched_response = body.respond_to_loads(0.).displacement;
  const Eigen::VectorXd all_loads = body.displacement(zero, 0.);
  for (std::size_t side = 0; side < 2; ++side)
  {
    const Trace &trace = body.contact_sides()[side];
    for (std::size_t node = 0; node < trace.n_nodes(); ++node)
      for (unsigned int c = 0; c < 2; ++c)
      {
        const auto i = body.trace_offset(side) + static_cast<Eigen::Index>(2 * node + c);
        EXPECT_NEAR(response[i], change[trace.node_dofs()[node][c]], 1e-12);
        EXPECT_NEAR(untouched_response[i], all_loads[trace.node_dofs()[node][c]], 1e-14);
      }
  }
  // Maxwell and Betti: the compliance is symmetric; its energy is the work of the forces.
  Eigen::VectorXd others = forces.reverse();
  EXPECT_NEAR(others.dot(response), forces.dot(Eigen::VectorXd(body.respond(others))), 1e-11);
  EXPECT_NEAR(.5 * forces.dot(response), body.strain_energy(change), 1e-11);
}

TEST(ElasticityBody, LoadResponseTellsForcesFromSupports)
{
  FiniteElementBody by_both(block("bottom: displacement: 0.01, 0.02*x; right: traction: 0.3, -0.1"), {"top"});
  FiniteElementBody by_force(block("bottom: displacement: 0, 0; right: traction: 0.3, -0.1"), {"top"});
  by_both.prepare();
  by_force.prepare();
  const LoadResponse both = by_both.respond_to_loads(0.), force = by_force.respond_to_loads(0.);
  EXPECT_LT((both.force_displacement - force.displacement).norm(), 1e-13);
  EXPECT_GT((both.displacement - force.displacement).norm(), 1e-2);
  const Eigen::VectorXd u = by_both.displacement(Eigen::VectorXd::Zero(by_both.trace_size()), 0.);
  EXPECT_NEAR(both.energy_product, 2. * by_both.strain_energy(u), 1e-13 * both.energy_product);
}

TEST(ElasticityBody, ARigidSideMovesAndCarriesItsForce)
{
  // Uniaxial strain: delta = -0.01 over the height 2 needs (lambda + 2 mu) 0.005 per length of 3.
  for (const std::string resultant : {"top: resultant: -1", "top: resultant: 0, -1"})
  {
    BodyDescription description = block(
        "left: normal displacement: 0; right: normal displacement: 0; bottom: normal displacement: 0; " +
        resultant);
    description.placement = Placement(1., false, 70., Vector2(-3., 8.));
    FiniteElementBody body(description, {});
    body.prepare();
    ASSERT_TRUE(body.resultant().has_value());
    const Vector2 along = body.resultant()->direction;
    const Vector2 down = description.placement.direction_to_world(Vector2(0., -1.));
    const double towards = along.dot(down); // -1 where the direction is the outward normal
    EXPECT_NEAR(std::abs(towards), 1., 1e-14);
    EXPECT_LT((body.resultant()->force * along - down).norm(), 1e-14);
    const Eigen::VectorXd none = Eigen::VectorXd();
    const Eigen::VectorXd u = body.displacement(Eigen::VectorXd::Zero(0), .01 * towards);
    EXPECT_NEAR(body.rigid_side_force(u, none) * towards, 3.5 * .005 * 3., 1e-13);
    EXPECT_LT((body.reactions(u, none).by_boundary.at("top") - 3.5 * .005 * 3. * down).norm(), 1e-13);
  }
}

TEST(ElasticityBody, CountsWhatItDoes)
{
  FiniteElementBody body(block("bottom: displacement: 0, 0"), {"top"});
  EXPECT_EQ(body.counters().meshes, 1u);
  EXPECT_EQ(body.counters().factorisations, 0u);
  body.prepare();
  body.respond(Eigen::MatrixXd::Zero(body.trace_size(), 3));
  EXPECT_EQ(body.counters().assemblies, 1u);
  EXPECT_EQ(body.counters().factorisations, 1u);
  EXPECT_EQ(body.counters().solves, 3u);
}

TEST(ElasticityBody, RefusesWhatDoesNotFit)
{
  const auto refuse = [](const std::string &conditions, const std::string &part) {
    expect_refused([&] { FiniteElementBody(block(conditions), {"top"}); }, part);
  };
  refuse("bottom: displacement: 0, 0; roof: pressure: 1", "roof");
  refuse("(0.1, 0): displacement: 0, 0", "(0, 0)");
  refuse("left: displacement: 0, 0; bottom: normal displacement: 0.1", "contradict");
  refuse("top: resultant: 0, 0; bottom: displacement: 0, 0", "zero vector");
  expect_refused([] { FiniteElementBody(block("bottom: displacement: 0, 0"), {"roof"}); }, "roof");
}

TEST(ElasticityBody, AMatrixThatCannotBeTrustedIsRefused)
{
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 1.;
  matrix.insert(1, 1) = 2.;
  matrix.makeCompressed();
  EXPECT_NO_THROW(SparseCholesky(matrix, "block"));
  for (const double entry :
       {-1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    matrix.coeffRef(1, 1) = entry;
    EXPECT_THROW(SparseCholesky(matrix, "block"), ComputationError) << entry;
  }
}

TEST(ElasticityBody, NumbersOutOfRangeAreNoticed)
{
  BodyDescription stiff = block("bottom: displacement: 0, 0");
  stiff.young_modulus = 1e308;
  stiff.poisson_ratio = .49;
  EXPECT_THROW(FiniteElementBody(stiff, {}).prepare(), ComputationError);

  BodyDescription soft = block("bottom: displacement: 0, 0; top: traction: 0, 1e300");
  soft.young_modulus = 1e-300;
  FiniteElementBody body(soft, {});
  body.prepare();
  EXPECT_THROW(body.displacement(Eigen::VectorXd(), 0.), ComputationError);
}
