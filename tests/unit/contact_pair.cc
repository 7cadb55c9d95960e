// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of sides: penalty, layer compliance, gap, sides that do not face.
#include <abut/contact/contact_surface.h>

#include "finite_elements_testing.h"

using namespace abut;

namespace
{
  ContactDescription description(const std::string &gap = "")
  {
    ContactDescription contact;
    contact.name = "interface";
    contact.slave = {"lower", "top"};
    contact.master = {"upper", "bottom"};
    if (!gap.empty())
      contact.gap = Expression(gap, {}, "test");
    return contact;
  }

  BodyDescription block(const double height, const unsigned int columns, const Placement &placement)
  {
    auto body = make_body("rectangle", {4., height}, {{columns, 2}});
    body.placement = placement;
    return body;
  }

  /// Two blocks, placed alike: [0, 4] x [0, 1] below and, `distance` above it, [0, 4] x [0, 2].
  struct Blocks
  {
    Blocks(const double scale, const bool mirrored, const double angle, const double distance)
        : lower_placement(scale, mirrored, angle, Vector2(7., -3.)),
          lower(block(1., 5, lower_placement), {"top"}),
          upper(block(2., 7,
                      Placement(scale, mirrored, angle,
                                lower_placement.point_to_world(Vector2(0., 1. + distance)))),
                {"bottom", "top"})
    {}

    ContactSurface surface(const ContactDescription &contact, const std::size_t master_side = 0) const
    {
      return ContactSurface({{&contact,
                              &lower_placement,
                              {0, 0, lower.contact_sides()[0], {40., .3}, 10.},
                              {1, master_side, upper.contact_sides()[master_side], {40. / 3., .3}, 10.}}});
    }

    Placement lower_placement;
    FiniteElementBody lower, upper;
  };
} // namespace

TEST(ContactPair, LayerCompliance)
{
  // A layer between rigid sides answers with lambda + 2 mu.
  const Material material{2.1e5, .3};
  EXPECT_NEAR(layer_compliance(material, 2.) * (material.lambda() + 2. * material.mu()), 2., 1e-14);
  EXPECT_NEAR(layer_compliance({4., 0.}, 2.), .5, 1e-15);
}

TEST(ContactPair, PenaltyIsTheMeanFlexibilityTimesItsCoefficient)
{
  const Blocks blocks(1., false, 0., 0.);
  ContactDescription contact = description();
  contact.penalty_coefficient = .02;
  EXPECT_NEAR(blocks.surface(contact).pairs()[0].penalty(), .02 / 2. * (.25 + .75), 1e-16);
  contact.penalty = 3e-7;
  EXPECT_EQ(blocks.surface(contact).pairs()[0].penalty(), 3e-7);
}

TEST(ContactPair, DepthsOfBlocksAreTheirHeights)
{
  const Blocks blocks(3., true, 50., .1);
  EXPECT_NEAR(blocks.lower.contact_depth(0), 3., 1e-12);
  EXPECT_NEAR(blocks.upper.contact_depth(0), 6., 1e-12);
}

TEST(ContactPair, GapOfTheGeometryIsTheDistance)
{
  for (const double distance : {.3, 0., -.2})
  {
    const Blocks blocks(2., true, 125., distance);
    const ContactDescription contact = description();
    const ContactSurface surface = blocks.surface(contact);
    const ContactPair &pair = surface.pairs()[0];
    EXPECT_TRUE(pair.gap_from_geometry());
    EXPECT_NEAR(pair.coverage(), 1., 1e-13);
    EXPECT_NEAR(pair.smallest_gap(), 2. * distance, 1e-13);
    EXPECT_NEAR(pair.largest_gap(), 2. * distance, 1e-13);
    EXPECT_LT((pair.gap_integrals() - 2. * distance * pair.weights()).norm(), 1e-13);
  }
}

TEST(ContactPair, GapExpressionIsReadInTheSlavesFrame)
{
  const Blocks blocks(2., true, 125., .3);
  ContactDescription contact = description("0.1 + 0.2*x + 5*(y - 1)");
  const ContactSurface surface = blocks.surface(contact);
  const ContactPair &pair = surface.pairs()[0];
  EXPECT_FALSE(pair.gap_from_geometry());
  const auto &parts = surface.partition().parts();
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const double x = blocks.lower_placement.point_to_own(parts[k].middle).x();
    const auto i = static_cast<Eigen::Index>(k);
    EXPECT_NEAR(pair.gap_integrals()[i] / pair.weights()[i], 2. * (.1 + .2 * x), 1e-13);
  }
}

TEST(ContactPair, SidesThatDoNotFaceAreRefused)
{
  const Blocks blocks(1., false, 0., 0.);
  ContactDescription contact = description();
  contact.master.boundary = "top";
  expect_refused([&] { blocks.surface(contact, 1); }, "Contact interface");
  expect_refused([&] { blocks.surface(contact, 1); }, "lower:top");
  expect_refused([&] { blocks.surface(contact, 1); }, "upper:top");
}

TEST(ContactPair, CoverageOfAShiftedBlock)
{
  const FiniteElementBody lower(block(1., 5, Placement()), {"top"});
  const FiniteElementBody upper(block(1., 3, Placement(1., false, 0., Vector2(3., 1.))), {"bottom"});
  const ContactDescription contact = description();
  const Placement placement;
  const ContactSurface surface({{&contact,
                                 &placement,
                                 {0, 0, lower.contact_sides()[0], {1., .3}, 1.},
                                 {1, 0, upper.contact_sides()[0], {1., .3}, 1.}}});
  EXPECT_NEAR(surface.pairs()[0].coverage(), .25, 1e-14);
}

namespace
{
  /// Pairs of sides of bodies without more than that.
  PairInput pair_of(const FiniteElementBody &slave, const std::size_t slave_body,
                    const std::size_t slave_side, const FiniteElementBody &master,
                    const std::size_t master_body, const std::size_t master_side)
  {
    static const ContactDescription contact = description();
    static const Placement placement;
    return {&contact,
            &placement,
            {slave_body, slave_side, slave.contact_sides()[slave_side], {1., .3}, 1.},
            {master_body, master_side, master.contact_sides()[master_side], {1., .3}, 1.}};
  }
} // namespace

TEST(ContactSurface, PairsOnOneSideAreOneSurface)
{
  const FiniteElementBody a(block(1., 4, Placement()), {"top", "bottom"});
  using Groups = std::vector<std::vector<std::size_t>>;
  // One lies on two, with slaves on either side; the pair of the other side stands alone.
  EXPECT_EQ(ContactSurface::group(
                {pair_of(a, 0, 0, a, 1, 1), pair_of(a, 2, 1, a, 0, 0), pair_of(a, 0, 1, a, 3, 0)}),
            (Groups{{0, 1}, {2}}));
  // A row of bricks upon bricks.
  EXPECT_EQ(ContactSurface::group(
                {pair_of(a, 0, 0, a, 1, 1), pair_of(a, 2, 0, a, 1, 1), pair_of(a, 2, 0, a, 3, 1)}),
            (Groups{{0, 1, 2}}));
  // Three sides that touch one another cannot be two rows: the third pair stands alone.
  EXPECT_EQ(ContactSurface::group(
                {pair_of(a, 0, 0, a, 1, 0), pair_of(a, 1, 0, a, 2, 0), pair_of(a, 2, 0, a, 0, 0)}),
            (Groups{{0, 1}, {2}}));
}

TEST(ContactSurface, TheFirstSlaveIsCut)
{
  const FiniteElementBody lower(block(1., 4, Placement()), {"top", "bottom"}),
      upper(block(1., 3, Placement(1., false, 0., Vector2(0., 1.))), {"bottom", "top"});
  for (const bool swapped : {false, true})
  {
    const PairInput pair = swapped ? pair_of(upper, 1, 0, lower, 0, 0) : pair_of(lower, 0, 0, upper, 1, 0);
    const ContactSurface surface({pair});
    EXPECT_EQ(surface.cut_sides()[0], swapped ? &upper.contact_sides()[0] : &lower.contact_sides()[0]);
    EXPECT_EQ(&surface.pairs()[0].cut_side(), &surface.pairs()[0].slave());
  }
}
