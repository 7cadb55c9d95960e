// SPDX-License-Identifier: LGPL-2.1-or-later
// Outlines of rigid bodies as curves, and what supports and loads make of them.
#include <abut/base/user_error.h>
#include <abut/bodies/rigid/rigid_body.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace abut;

namespace
{
  BodyDescription described(const std::string &outline, const std::string &conditions = "")
  {
    BodyDescription body;
    body.name = "block";
    body.shape = "rigid outline";
    body.is_rigid = true;
    body.outline = parse_outline(outline, {}, "Outline");
    if (!conditions.empty())
      body.conditions = parse_conditions(conditions, {}, "Conditions");
    return body;
  }

  /// The area that a closed curve goes around, the side's body on the left.
  double area_inside(const Trace &side)
  {
    const GaussRule rule(8);
    double area = 0.;
    for (const Segment &segment : side.segments())
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const Vector2 point = side.point(segment, rule.points[q]),
                      tangent = side.tangent(segment, rule.points[q]);
        area += .5 * rule.weights[q] * (point.x() * tangent.y() - point.y() * tangent.x());
      }
    return area;
  }

  const std::string square = "(0, 0) -> base: (4, 0) -> right: (4, 2) -> top: (0, 2) -> close";
} // namespace

TEST(RigidOutline, ArcsAndGraphsAreNextToTheirCurves)
{
  const RigidOutline disc(described("rim: circle (1, 2) 3"));
  const Trace rim = disc.side("rim");
  for (const Segment &segment : rim.segments())
    for (double s = 0.; s <= 1.; s += .1)
      EXPECT_NEAR((rim.point(segment, s) - Vector2(1., 2.)).norm(), 3., 3e-9);
  EXPECT_NEAR(rim.length(), 6. * M_PI, 1e-7);
  EXPECT_NEAR(area_inside(rim), 9. * M_PI, 1e-7);

  const RigidOutline hill(described("(5, 0) -> hill: y = 5*cos(0.1*pi*x) to (-5, 0) -> close"));
  const Trace graph = hill.side("hill");
  for (const Segment &segment : graph.segments())
    for (double s = 0.; s <= 1.; s += .1)
    {
      const Vector2 point = graph.point(segment, s);
      EXPECT_NEAR(point.y(), 5. * std::cos(.1 * M_PI * point.x()), 2e-8);
    }
}

TEST(RigidOutline, TheBodyLiesOnTheLeftHoweverItIsWrittenAndPlaced)
{
  for (const bool mirror : {false, true})
    for (const std::string outline : {"(0, 0) -> (4, 0) -> (4, 4) -> (0, 4) -> close; bore: circle (2, 2) 1",
                                      "(0, 0) -> (0, 4) -> (4, 4) -> (4, 0) -> close; (3, 2) -> bore: arc "
                                      "(2, 1) (1, 2) -> bore: arc (2, 3) (3, 2)"})
    {
      BodyDescription body = described(outline);
      body.placement = {2., mirror, 30., Vector2(5., 6.)};
      const RigidOutline plate(body);
      EXPECT_NEAR(area_inside(plate.side("0")), 64., 1e-9);
      EXPECT_NEAR(area_inside(plate.side("bore")), -4. * M_PI, 1e-7);
    }
}

TEST(RigidOutline, SidesTakenTogetherAreOneCurve)
{
  const RigidOutline block(described(square));
  EXPECT_EQ(block.side_names(), (std::vector<std::string>{"0", "base", "right", "top"}));
  const Trace around = block.side("base + right + top");
  ASSERT_GE(around.segments().size(), 3u);
  EXPECT_NEAR(around.length(), 10., 1e-12);
  EXPECT_EQ(around.n_nodes(), around.segments().size() * RigidOutline::degree + 1u); // one open curve
  // One that goes on through the start of the outline begins before it.
  const Trace through = block.side("0 + base");
  EXPECT_TRUE(through.following(0));
  EXPECT_NEAR(through.segments()[0].points.front().y(), 2., 1e-14);
  EXPECT_EQ(RigidOutline(described("(0, 0) -> (1, 0) -> (0, 1) -> close")).side_names(),
            (std::vector<std::string>{"1", "2", "3"}));
  for (const std::string wrong : {"left", "base + left", "base + base"})
    EXPECT_THROW(block.side(wrong), UserError) << wrong;
}

TEST(RigidBody, MovesAsItsSupportsSay)
{
  const RigidBody body(described(square, "base: displacement: -0.1*y, 0.2 + 0.1*x"), {"top"});
  EXPECT_TRUE(body.free_rigid_motions().empty());
  const Eigen::VectorXd trace = body.prescribed_trace();
  const Trace &top = body.contact_sides()[0];
  for (std::size_t i = 0; i < top.n_nodes(); ++i)
  {
    const Vector2 &place = top.node_points()[i];
    EXPECT_NEAR(trace[2 * static_cast<Eigen::Index>(i)], -.1 * place.y(), 1e-14);
    EXPECT_NEAR(trace[2 * static_cast<Eigen::Index>(i) + 1], .2 + .1 * place.x(), 1e-14);
  }
  EXPECT_TRUE(body.respond(Eigen::MatrixXd::Ones(trace.size(), 2)).isZero(0.));
}

TEST(RigidBody, SupportsShareByTheirLengths)
{
  const RigidBody beam(
      described("(0, 0) -> a: y = 0 to (2, 0) -> (4, 0) -> b: (6, 0) -> top: (6, 1) -> top: (0, 1) -> close",
                "a: displacement: 0, 0; b: displacement: 0, 0; (3, 0.5): displacement x: 0; "
                "top: traction: 0, if(abs(x - 3) < 0.1, -5, 0)"),
      {});
  const Reactions reactions = beam.reactions({}, {});
  EXPECT_NEAR(reactions.applied.y(), -1., 1e-6); // on a tenth of a piece
  EXPECT_NEAR(reactions.by_boundary.at("a").y(), .5, 2e-3);
  EXPECT_NEAR(reactions.by_boundary.at("b").y(), .5, 2e-3);
}

TEST(RigidBody, RefusesWhatWouldDeformIt)
{
  for (const std::string conditions :
       {"base: displacement: 0.01*x, 0", "base: displacement y: 0; top: displacement y: 0.1",
        "base: displacement y: 0.001*x^2", "(0, 0): displacement: 0, 0; (4, 0): displacement x: 0.1"})
    EXPECT_THROW(RigidBody(described(square, conditions), {"top"}), UserError) << conditions;
}

TEST(RigidBody, MotionsAndForcesWork)
{
  // A lid on a hinge under pressure 3 on its top, 4 long: moment 24 about the hinge.
  const RigidBody lid(described(square, "(0, 0): displacement: 0, 0; top: pressure: 3"), {"base"});
  ASSERT_EQ(lid.free_rigid_motions(), std::vector<std::string>{"rotation about (0, 0)"});
  const BodyMotions motions = lid.motions();
  ASSERT_EQ(motions.traces.cols(), 1);
  const Trace &base = lid.contact_sides()[0];
  const auto end = static_cast<Eigen::Index>(2 * base.segments().back().nodes.back() + 1); // y at (4, 0)
  EXPECT_NEAR(motions.loads[0] / motions.traces(end, 0), -24. / 4., 1e-10);
  EXPECT_EQ(motions.stiffness(0, 0), 0.);

  Eigen::VectorXd forces = Eigen::VectorXd::Zero(lid.trace_size());
  forces[end] = 6.;
  const Reactions reactions = lid.reactions({}, forces);
  EXPECT_NEAR(reactions.by_boundary.at("(0, 0)").y(), 6., 1e-10);
  EXPECT_NEAR(reactions.equilibrium_residual, 0., 1e-12);
  EXPECT_NEAR(reactions.moment_residual, 0., 1e-12);

  // A side with a given resultant takes the whole body along.
  const RigidBody punch(described(square, "top: resultant: 5; (0, 0): displacement x: 0"), {"base"});
  EXPECT_TRUE(punch.free_rigid_motions().empty());
  const BodyMotions pressed = punch.motions();
  EXPECT_NEAR(pressed.loads[0], 5., 1e-12);
  EXPECT_NEAR(pressed.traces(end, 0), 1., 1e-12);
}
