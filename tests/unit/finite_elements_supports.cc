// SPDX-License-Identifier: LGPL-2.1-or-later
// Conditions at nodes, and the rigid motions they leave free.
#include <abut/bodies/finite_elements/supports.h>
#include <abut/bodies/rigid_modes.h>

#include "finite_elements_testing.h"
#include <algorithm>

using namespace abut;

namespace
{
  const std::vector<std::array<unsigned int, 2>> two_nodes = {{{0, 1}}, {{2, 3}}};

  PrescribedComponent at(const unsigned int node, const Vector2 &direction, const double value,
                         const std::string &boundary = "side", const double per_unit = 0.)
  {
    return {{{2 * node, 2 * node + 1}}, Vector2(3., 4.), direction.normalized(), value, per_unit, boundary};
  }

  std::vector<std::string> free_motions(const std::vector<PrescribedComponent> &components)
  {
    std::vector<std::string> descriptions;
    for (const RigidMode &mode : free_rigid_modes(components, Vector2(10., 20.), 5.))
      descriptions.push_back(mode.description());
    return descriptions;
  }

  PrescribedComponent hold(const Vector2 &place, const Vector2 &direction)
  {
    return {{{0, 1}}, place, direction.normalized(), 0., 0., "side"};
  }
} // namespace

TEST(ElasticitySupports, NothingPrescribedLeavesEverythingFree)
{
  const Supports supports = make_supports("b", two_nodes, 4, {});
  EXPECT_EQ(supports.free_directions.cols(), 4);
  EXPECT_EQ(supports.fixed.norm(), 0.);
  EXPECT_TRUE(supports.nodes.empty());
}

TEST(ElasticitySupports, CornerOfTwoRollersTakesBothValues)
{
  // The trap: a left roller and a top that is moved down must give (0, -Delta), not (0, 0).
  const Supports supports =
      make_supports("b", two_nodes, 4, {at(1, {-1., 0.}, 0., "left"), at(1, {0., 1.}, -.25, "top")});
  EXPECT_EQ(supports.free_directions.cols(), 2);
  EXPECT_EQ(supports.fixed[2], 0.);
  EXPECT_EQ(supports.fixed[3], -.25);
  ASSERT_EQ(supports.nodes.size(), 1u);
  EXPECT_EQ(supports.nodes[0].boundaries, (std::vector<std::string>{"left", "top"}));
}

TEST(ElasticitySupports, ARollerOfAnyDirectionFreesTheOther)
{
  for (const double angle : {0., .3, 1.2, 2.5, 4.})
  {
    const Vector2 normal(std::cos(angle), std::sin(angle));
    const Supports supports = make_supports("b", two_nodes, 4, {at(0, normal, .5)});
    ASSERT_EQ(supports.free_directions.cols(), 3);
    const Eigen::MatrixXd t = supports.free_directions;
    EXPECT_LT((t.transpose() * t - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_NEAR(normal.dot(t.topRows(2) * Eigen::Vector3d::Ones()), 0., 1e-15);
    EXPECT_LT((supports.fixed.head<2>() - .5 * normal).norm(), 1e-15);
  }
}

TEST(ElasticitySupports, TwoInclinedDirectionsAreSolvedTogether)
{
  const Vector2 u(.3, -.7), a = Vector2(1., 1.).normalized(), b = Vector2(-.2, 1.).normalized();
  const Supports supports = make_supports("b", two_nodes, 4, {at(0, a, a.dot(u)), at(0, b, b.dot(u))});
  EXPECT_LT((supports.fixed.head<2>() - u).norm(), 1e-15);
}

TEST(ElasticitySupports, TheRigidSidesShareIsSolvedTogether)
{
  const Vector2 roller = Vector2(1., 2.).normalized();
  const Supports supports =
      make_supports("b", two_nodes, 4, {at(0, roller, 0.), at(0, {0., 1.}, 0., "top", 1.)});
  EXPECT_NEAR(supports.moving[1], 1., 1e-15);
  EXPECT_NEAR(roller.dot(supports.moving.head<2>()), 0., 1e-15);
  EXPECT_EQ(supports.fixed.norm(), 0.);
}

TEST(ElasticitySupports, SayingTheSameTwiceIsAccepted)
{
  const Supports supports =
      make_supports("b", two_nodes, 4,
                    {at(0, {1., 0.}, .1, "a"), at(0, {0., 1.}, .2, "a"), at(0, {1., 0.}, .1, "b"),
                     at(0, {0., -1.}, -.2, "c"), at(0, {1., 1.}, .3 / std::sqrt(2.), "d")});
  EXPECT_NEAR(supports.fixed[0], .1, 1e-15);
  EXPECT_NEAR(supports.fixed[1], .2, 1e-15);
}

TEST(ElasticitySupports, ContradictionsAreRefusedWithTheNodesPlace)
{
  const auto refuse = [](const std::vector<PrescribedComponent> &components, const std::string &sides) {
    expect_refused([&] { make_supports("block", two_nodes, 4, components); }, "(3, 4)");
    expect_refused([&] { make_supports("block", two_nodes, 4, components); }, sides);
    expect_refused([&] { make_supports("block", two_nodes, 4, components); }, "block");
  };
  refuse({at(0, {1., 0.}, .1, "left"), at(0, {1., 0.}, .2, "top")}, "'left' and 'top'");
  refuse({at(0, {1., 0.}, .1, "left"), at(0, {-1., 0.}, .1, "top")}, "'left' and 'top'");
  refuse({at(0, {1., 0.}, 0., "left"), at(0, {0., 1.}, 0., "left"), at(0, {1., 1.}, 1e-9, "top")},
         "'left' and 'top'");
  refuse({at(0, {1., 0.}, 0., "left"), at(0, {1., 0.}, 0., "top", 1.)}, "'left' and 'top'");
}

TEST(ElasticitySupports, FreeMotionsOfNothingAndOfOneRoller)
{
  EXPECT_EQ(free_motions({}).size(), 3u);

  // A straight roller side below: it slides along x and nothing else.
  const auto sliding = free_motions({hold({8., 18.}, {0., -1.}), hold({12., 18.}, {0., -1.})});
  ASSERT_EQ(sliding.size(), 1u);
  EXPECT_TRUE(sliding[0] == "translation along (1, 0)" || sliding[0] == "translation along (-1, 0)")
      << sliding[0];
}

TEST(ElasticitySupports, FreeMotionsOfPoints)
{
  const Vector2 x = Vector2::UnitX(), y = Vector2::UnitY();
  const auto pinned = free_motions({hold({7., 21.}, x), hold({7., 21.}, y)});
  ASSERT_EQ(pinned.size(), 1u);
  EXPECT_EQ(pinned[0], "rotation about (7, 21)");

  EXPECT_TRUE(free_motions({hold({7., 21.}, x), hold({7., 21.}, y), hold({9., 21.}, y)}).empty());
  // The second point's condition does not resist turning about the first one.
  EXPECT_EQ(free_motions({hold({7., 21.}, x), hold({7., 21.}, y), hold({9., 21.}, x)}).size(), 1u);
  EXPECT_EQ(free_motions({hold({7., 21.}, x)}).size(), 2u);
}

TEST(ElasticitySupports, RollersWithNormalsThroughOnePointLeaveARotation)
{
  std::vector<PrescribedComponent> components;
  for (const double angle : {.1, .9, 1.3, 1.5})
  {
    const Vector2 normal(std::cos(angle), std::sin(angle));
    components.push_back(hold(Vector2(6., 17.) + 3. * normal, normal));
  }
  const auto motions = free_motions(components);
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0], "rotation about (6, 17)");
  components.push_back(hold(Vector2(6., 20.), Vector2::UnitX()));
  EXPECT_TRUE(free_motions(components).empty());
}

TEST(ElasticitySupports, ARoundBodyOnItsArcCanTurn)
{
  for (const std::string shape : {"disc", "half disc", "quarter disc", "ring", "quarter ring"})
    for (unsigned int degree = 1; degree <= 3; ++degree)
      for (const unsigned int cells : {2u, 4u, 8u})
      {
        const bool is_ring = shape == "ring" || shape == "quarter ring";
        auto description =
            make_body(shape, is_ring ? std::vector<double>{1., 2.} : std::vector<double>{2.}, {{cells, 1}});
        description.degree = degree;
        description.placement = Placement(1., false, 0., Vector2(3., 4.));
        set_conditions(description, "outer: normal displacement: 0");
        const FiniteElementBody body(description, {});
        EXPECT_EQ(body.free_rigid_motions().size(), 1u)
            << shape << ", degree " << degree << ", cells " << cells;
        if (body.free_rigid_motions().size() == 1)
        {
          EXPECT_EQ(body.free_rigid_motions()[0], "rotation about (3, 4)");
        }
      }
}

TEST(ElasticitySupports, PlacesFarFromTheOriginChangeNothing)
{
  auto description = make_body("rectangle", {4., 1.}, {{64, 16}});
  for (const double shift : {0., 1000., 1e5})
  {
    description.placement = Placement(1., false, 37., Vector2(shift, -shift));
    set_conditions(description, "bottom: normal displacement: 0");
    EXPECT_EQ(FiniteElementBody(description, {}).free_rigid_motions().size(), 1u) << shift;
    set_conditions(description, "bottom: normal displacement: 0; (0, 0): displacement x: 0");
    EXPECT_TRUE(FiniteElementBody(description, {}).free_rigid_motions().empty()) << shift;
  }
}
