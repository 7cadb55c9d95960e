// SPDX-License-Identifier: LGPL-2.1-or-later
// Outlines and mesh sizes: what is read, what is refused.
#include <abut/base/user_error.h>
#include <abut/scene/mesh_size.h>
#include <abut/scene/outline.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  const Constants radius{{"R", 2.}};

  std::vector<OutlineLoop> read(const std::string &text)
  {
    return parse_outline(text, radius, "Outline");
  }

  void expect_refused(const std::string &text, const std::string &part)
  {
    try
    {
      read(text);
      ADD_FAILURE() << "nothing was refused: " << text;
    }
    catch (const UserError &error)
    {
      EXPECT_EQ(std::string(error.what()).find("Outline: "), 0u) << error.what();
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }

  void expect_point(const Vector2 &point, const double x, const double y)
  {
    EXPECT_NEAR(point.x(), x, 1e-14);
    EXPECT_NEAR(point.y(), y, 1e-14);
  }
} // namespace

TEST(Outline, LinesWithNames)
{
  const auto loops = read("(0, 0) -> base: (R, 0) -> (R, 1/2) -> close");
  ASSERT_EQ(loops.size(), 1u);
  const auto &pieces = loops[0].pieces;
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].side, "base");
  EXPECT_EQ(pieces[1].side, "");
  expect_point(pieces[1].points.back(), 2., .5);
  expect_point(pieces[2].points.back(), 0., 0.);
}

TEST(Outline, ArcsOfBothKindsAndDirections)
{
  for (const std::string text : {"(1, 0) -> arc (0, 1) (-1, 0) -> arc (0, -1) (1, 0)",
                                 "(1, 0) -> arc (0, -1) (-1, 0) -> arc (0, 1) (1, 0)",
                                 "(1, 0) -> centre (0, 0) (0, 1) -> centre (0, 0) (-1, 0) -> centre (0, 0) "
                                 "(0, -1) -> centre (0, 0) (1, 0)",
                                 "circle (0, 0) 1"})
  {
    const auto loops = read(text);
    ASSERT_EQ(loops[0].pieces.size(), 4u) << text; // quarters
    for (const OutlinePiece &piece : loops[0].pieces)
    {
      expect_point(piece.points.front(), 0., 0.);
      EXPECT_NEAR(piece.points.back().norm(), 1., 1e-14);
    }
  }
  // Three quarters of a circle through a point on it.
  const auto loops = read("(1, 0) -> arc (-1, 0) (0, -1) -> (0, 0) -> close");
  ASSERT_EQ(loops[0].pieces.size(), 5u);
  expect_point(loops[0].pieces[1].points.back(), -1., 0.);
}

TEST(Outline, HolesAndSplines)
{
  const auto loops =
      read("rim: circle (0, 0) 2*R; bore: circle (1, 0) 1; (-3, 0) -> spline (-2, 1) (-1, 0) -> close");
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[1].pieces[0].side, "bore");
  EXPECT_EQ(loops[2].pieces[0].kind, OutlinePiece::Kind::spline);
  EXPECT_EQ(loops[2].pieces[0].points.size(), 2u);
}

TEST(Outline, AFormulaIsASplineOfManyPoints)
{
  const auto loops = read("(3, 0) -> hill: y = R*(9 - x^2) to (-3, 0) -> close");
  const OutlinePiece &hill = loops[0].pieces[0];
  EXPECT_EQ(hill.side, "hill");
  EXPECT_EQ(hill.kind, OutlinePiece::Kind::spline);
  ASSERT_TRUE(hill.height);
  EXPECT_GT(hill.points.size(), 100u);
  for (const Vector2 &point : hill.points)
    EXPECT_NEAR(point.y(), 2. * (9. - point.x() * point.x()), 1e-12);
  expect_refused("(3, 0) -> y = x^2 to (-3, 9) -> close", "is at y = 9 and not 0 where x = 3");
  expect_refused("(0, 0) -> y = x^2 to (0, 2) -> close", "two different x");
  expect_refused("(0, 0) -> y = sqrt(-x) to (2, 2) -> close", "no finite value");
  expect_refused("(0, 0) -> y = Q*x to (2, 2) -> close", "not a formula");
  expect_refused("(0, 0) -> y = x (2, 2) -> close", "received `y = x (2, 2)`");
}

TEST(Outline, WhatCannotBeReadIsRefused)
{
  expect_refused("", "received no curve");
  expect_refused("(0, 0)", "has no pieces");
  expect_refused("(0, 0) -> (1, 0) -> (1, 1)", "ends at (1, 1), it must be closed");
  expect_refused("(0, 0) -> (1, 0) -> (1, 0) -> close", "a piece ends where it begins, at (1, 0)");
  expect_refused("(0, 0) -> (1, 1) -> (1, 0) -> (0, 1) -> close", "its curves meet near");
  expect_refused("circle (0, 0) 1; circle (3, 0) 1", "lies outside");
  expect_refused("circle (0, 0) 3; circle (0, 0) 2; circle (0, 0) 1", "lies in a hole");
  expect_refused("circle (0, 0) 1; circle (1, 0) 1", "its curves meet near");
  expect_refused("circle (0, 0) -1", "allowed are radii above 0");
  expect_refused("circle (0, 0)", "circle (x, y) radius");
  expect_refused("(0, 0) -> bend (1, 0) (1, 1) -> close", "received `bend (1, 0) (1, 1)`");
  expect_refused("(0, 0) -> arc (1, 0) (2, 0) -> close", "not on one line");
  expect_refused("(0, 0) -> centre (1, 0) (2, 1) -> close", "as far from the start as from the end");
  expect_refused("(0, 0) -> centre (1, 0) (2, 0) -> close", "less than half a circle");
  expect_refused("(0, 0) -> (1, 0, 0) -> close", "a point is written (x, y)");
  expect_refused("(0, 0) -> (Q, 0) -> close", "Q");
  expect_refused("(0, 0) -> (1, 0) 7 -> close", "received `(1, 0) 7`");
  expect_refused("(0, 0) -> : (1, 0) -> close", "needs a name before the colon");
}

TEST(MeshSizeText, GeneralAndLocal)
{
  const MeshSize size = parse_mesh_size("R; bore: 0.5; (10, 0): 0.1", radius, "Mesh size");
  EXPECT_EQ(size.everywhere, 2.);
  ASSERT_EQ(size.on_sides.size(), 1u);
  EXPECT_EQ(size.on_sides[0].first, "bore");
  ASSERT_EQ(size.at_points.size(), 1u);
  EXPECT_EQ(size.at_points[0].second, .1);
  EXPECT_EQ(parse_mesh_size("0", radius, "Mesh size").everywhere, 0.);
  for (const std::string wrong : {"-1", "bore: 0", "bore: 1: 2", ": 1", "x", "1; 2"})
  {
    EXPECT_THROW(parse_mesh_size(wrong, radius, "Mesh size"), UserError) << wrong;
  }
}
