// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A body that lives elsewhere: what it tells arrives to the last digit, and only other questions make its
// mesh.
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/travelling_body.h>
#include <abut/scene/condition.h>

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

using namespace abut;

namespace
{
  const std::vector<std::string> contact_sides = {"inner", "left"};

  /// A quarter of a ring between planes of symmetry, loaded from outside: curves, supports that turn normals,
  /// a load that a support takes.
  BodyDescription ring()
  {
    BodyDescription body;
    body.name = "ring";
    body.shape = "quarter ring";
    body.size = {1., 2.};
    body.cells = {{6, 3}};
    body.degree = 2;
    body.young_modulus = 7.;
    body.poisson_ratio = .3;
    body.conditions = parse_conditions("bottom: normal displacement: 0; left: normal displacement: 0; "
                                       "outer: pressure: 1; left: traction: 1, 0",
                                       {}, "ring");
    return body;
  }

  CellMarks some_marks(const Body &body)
  {
    CellMarks marks = no_marks(body.counts().cells);
    for (std::size_t cell = 0; cell < marks.refine.size(); ++cell)
      marks.refine[cell] = cell % 5 == 0;
    return marks;
  }

  /// What one process has told another.
  BodyFacts sent(const BodyFacts &facts)
  {
    Bytes bytes = packed(facts);
    BodyFacts received;
    unpack(bytes, received);
    return received;
  }

  std::string description_of(const Body &body)
  {
    std::ostringstream text;
    body.describe(text);
    return text.str();
  }

  void expect_same_side(const Trace &side, const Trace &expected)
  {
    EXPECT_EQ(side.node_points(), expected.node_points());
    EXPECT_EQ(side.node_normals(), expected.node_normals());
    EXPECT_EQ(side.node_dofs(), expected.node_dofs());
    EXPECT_EQ(side.node_arc_lengths(), expected.node_arc_lengths());
    ASSERT_EQ(side.segments().size(), expected.segments().size());
    for (std::size_t i = 0; i < side.segments().size(); ++i)
    {
      const Segment &segment = side.segments()[i], &other = expected.segments()[i];
      EXPECT_EQ(segment.cell, other.cell);
      EXPECT_EQ(segment.end_normals, other.end_normals);
      EXPECT_EQ(side.point(segment, .3), expected.point(other, .3));
      EXPECT_EQ(side.following(i), expected.following(i));
      for (const double s : {0., .4, 1.})
        EXPECT_EQ(side.is_held(segment, s, Vector2(1., 0.)), expected.is_held(other, s, Vector2(1., 0.)));
    }
  }

  void expect_same_facts(const Body &body, const Body &expected)
  {
    EXPECT_EQ(description_of(body), description_of(expected));
    EXPECT_EQ(body.counts().dofs, expected.counts().dofs);
    EXPECT_EQ(body.mesh_version(), expected.mesh_version());
    EXPECT_EQ(body.mesh_quality().regularity, expected.mesh_quality().regularity);
    EXPECT_EQ(body.free_rigid_motions(), expected.free_rigid_motions());
    EXPECT_EQ(body.is_supported(), expected.is_supported());
    EXPECT_EQ(body.prescribed_trace(), expected.prescribed_trace());
    EXPECT_EQ(body.why_no_bound(), expected.why_no_bound());
    EXPECT_EQ(body.lost_load("left").lost, expected.lost_load("left").lost);
    EXPECT_GT(body.lost_load("left").lost, 0.);
    EXPECT_EQ(body.counters().meshes, expected.counters().meshes);
    ASSERT_EQ(body.contact_sides().size(), contact_sides.size());
    for (std::size_t side = 0; side < contact_sides.size(); ++side)
    {
      expect_same_side(body.contact_sides()[side], expected.contact_sides()[side]);
      EXPECT_EQ(body.contact_depth(side), expected.contact_depth(side));
      EXPECT_TRUE(body.material_behind(side) == expected.material_behind(side));
    }
    const std::vector<BoundarySide> sides = body.boundary(), expected_sides = expected.boundary();
    ASSERT_EQ(sides.size(), expected_sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      EXPECT_EQ(sides[i].names, expected_sides[i].names);
      expect_same_side(sides[i].curve, expected_sides[i].curve);
    }
    const Eigen::VectorXd field =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(expected.counts().dofs), -1., 2.);
    EXPECT_EQ(body.trace_of(field), expected.trace_of(field));
  }
} // namespace

TEST(TravellingBody, TellsAllThatOthersNeedWithoutItsMesh)
{
  const FiniteElementBody expected(ring(), contact_sides);
  TravellingBody here(ring(), contact_sides), elsewhere(ring(), contact_sides);
  const BodyFacts told = here.tell();
  here.learn(told);
  elsewhere.learn(sent(told));
  expect_same_facts(here, expected);
  expect_same_facts(elsewhere, expected);
  EXPECT_TRUE(here.is_whole());
  EXPECT_FALSE(elsewhere.is_whole());
}

TEST(TravellingBody, IsMadeWhereOtherThingsAreAsked)
{
  FiniteElementBody expected(ring(), contact_sides);
  TravellingBody elsewhere(ring(), contact_sides);
  elsewhere.learn(facts_of(expected, contact_sides));
  EXPECT_EQ(elsewhere.cells().size(), expected.counts().cells);
  EXPECT_TRUE(elsewhere.is_whole());
  expected.prepare();
  elsewhere.prepare();
  const Eigen::VectorXd forces = Eigen::VectorXd::Ones(expected.trace_size());
  EXPECT_EQ(elsewhere.displacement(forces, 0.), expected.displacement(forces, 0.));
  EXPECT_EQ(elsewhere.counters().solves, expected.counters().solves);
  EXPECT_EQ(&as_finite_elements(elsewhere, "this test"), &elsewhere.whole());
}

TEST(TravellingBody, RefusesToBeAnotherOneElsewhere)
{
  BodyDescription more_cells = ring(), thicker = ring(); // as after a mesh file was changed
  more_cells.cells = {{6, 4}};
  thicker.size = {1., 2.000001};
  for (const BodyDescription &other : {more_cells, thicker})
  {
    TravellingBody asked(ring(), contact_sides), told(ring(), contact_sides);
    const BodyFacts facts = facts_of(FiniteElementBody(other, contact_sides), contact_sides);
    asked.learn(facts);
    told.whole();
    for (const std::function<void()> &refused :
         {std::function<void()>([&] { asked.whole(); }), std::function<void()>([&] { told.learn(facts); })})
      try
      {
        refused();
        FAIL() << "nothing was said";
      }
      catch (const ComputationError &error)
      {
        EXPECT_NE(std::string(error.what()).find("Body ring: its mesh, of 18 cells, is not that of another"),
                  std::string::npos)
            << error.what();
      }
  }
}

TEST(TravellingBody, GivesBackItsMeshWhereItLeaves)
{
  const FiniteElementBody expected(ring(), contact_sides);
  TravellingBody body(ring(), contact_sides);
  body.learn(body.tell());
  EXPECT_TRUE(body.is_whole());
  body.leave();
  EXPECT_FALSE(body.is_whole());
  expect_same_facts(body, expected);
  EXPECT_EQ(body.cells().size(), expected.counts().cells);
}

TEST(TravellingBody, FollowsTheMeshWhereverItLives)
{
  FiniteElementBody expected(ring(), contact_sides);
  // One lives here, one is not made until the end, one is made on the way, as where it is drawn.
  TravellingBody here(ring(), contact_sides), late(ring(), contact_sides), drawn(ring(), contact_sides);
  const BodyFacts first = here.tell();
  for (TravellingBody *const body : {&here, &late, &drawn})
    body->learn(sent(first));
  for (int pass = 0; pass < 3; ++pass)
  {
    const CellMarks marks = some_marks(expected);
    const Eigen::VectorXd field =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(expected.counts().dofs), -1., 2. + pass);
    const std::vector<Eigen::VectorXd> carried = here.adapt(marks, {field});
    EXPECT_EQ(carried.front(), expected.adapt(marks, {field}).front());
    const BodyFacts told = here.tell();
    for (TravellingBody *const body : {&here, &late, &drawn})
      body->learn(sent(told), marks);
    if (pass == 0)
    {
      EXPECT_EQ(drawn.cells().size(), expected.counts().cells);
    }
    for (const TravellingBody *const body : {&here, &late, &drawn})
      expect_same_facts(*body, expected);
  }
  EXPECT_FALSE(late.is_whole());
  expected.prepare();
  const Eigen::VectorXd forces = Eigen::VectorXd::Ones(expected.trace_size());
  for (TravellingBody *const body : {&here, &late, &drawn})
  {
    body->prepare();
    EXPECT_EQ(body->displacement(forces, 0.), expected.displacement(forces, 0.));
  }
}
