// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of sides: penalty, layer compliance, gap, sides that do not face.
#include <abut/contact/contact_pair.h>
#include <abut/contact/elastic_layer.h>

#include "elasticity_testing.h"

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
    auto body = make_body(Shape::rectangle, {4., height}, {{columns, 2}});
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

    ContactPair pair(const ContactDescription &contact, const std::size_t master_side = 0) const
    {
      return ContactPair(contact, lower_placement, {0, 0, 10., .25, .1}, {1, master_side, 10., .75, .2},
                         lower.contact_sides()[0], upper.contact_sides()[master_side]);
    }

    Placement lower_placement;
    Body lower, upper;
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
  EXPECT_NEAR(blocks.pair(contact).penalty(), .02 / 2. * (.25 + .75), 1e-16);
  contact.penalty = 3e-7;
  EXPECT_EQ(blocks.pair(contact).penalty(), 3e-7);
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
    const ContactPair pair = blocks.pair(description());
    EXPECT_TRUE(pair.gap_from_geometry());
    EXPECT_NEAR(pair.coverage(), 1., 1e-13);
    EXPECT_NEAR(pair.coupling().smallest_gap, 2. * distance, 1e-13);
    EXPECT_NEAR(pair.coupling().largest_gap, 2. * distance, 1e-13);
    EXPECT_LT((pair.coupling().gap - 2. * distance * pair.coupling().weights).norm(), 1e-13);
  }
}

TEST(ContactPair, GapExpressionIsReadInTheSlavesFrame)
{
  const Blocks blocks(2., true, 125., .3);
  const ContactPair pair = blocks.pair(description("0.1 + 0.2*x + 5*(y - 1)"));
  EXPECT_FALSE(pair.gap_from_geometry());
  const Trace &slave = blocks.lower.contact_sides()[0];
  for (std::size_t i = 0; i < slave.n_nodes(); ++i)
  {
    const double x = blocks.lower_placement.point_to_own(slave.node_points()[i]).x();
    const auto k = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(pair.coupling().gap[k] / pair.coupling().weights[k], 2. * (.1 + .2 * x), 1e-13);
  }
}

TEST(ContactPair, SidesThatDoNotFaceAreRefused)
{
  const Blocks blocks(1., false, 0., 0.);
  ContactDescription contact = description();
  contact.master.boundary = "top";
  expect_refused([&] { blocks.pair(contact, 1); }, "Contact interface");
  expect_refused([&] { blocks.pair(contact, 1); }, "lower:top");
  expect_refused([&] { blocks.pair(contact, 1); }, "upper:top");
}

TEST(ContactPair, CoverageOfAShiftedBlock)
{
  const Body lower(block(1., 5, Placement()), {"top"});
  const Body upper(block(1., 3, Placement(1., false, 0., Vector2(3., 1.))), {"bottom"});
  const ContactPair pair(description(), Placement(), {0, 0, 1., 1., 1.}, {1, 0, 1., 1., 1.},
                         lower.contact_sides()[0], upper.contact_sides()[0]);
  EXPECT_NEAR(pair.coverage(), .25, 1e-14);
}
