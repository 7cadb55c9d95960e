// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/condition.h>

#include "scene_testing.h"

using namespace abut;

namespace
{
  std::vector<Condition> parse(const std::string &text)
  {
    return parse_conditions(text, {{"d", 0.25}}, "here");
  }

  std::string condition_error(const std::string &text)
  {
    return message_of([&] { parse(text); });
  }
} // namespace

TEST(Condition, splits_at_semicolons_two_colons_and_outer_commas)
{
  const auto conditions = parse(
      "left: normal displacement: 0; 7 : displacement : if(x<1,2,3), x<1?d:4;outer:pressure:max(1,2) ; ");
  ASSERT_EQ(conditions.size(), 3u);
  EXPECT_EQ(conditions[0].boundary, "left");
  EXPECT_EQ(conditions[0].kind, ConditionKind::normal_displacement);
  EXPECT_EQ(conditions[1].boundary, "7");
  EXPECT_EQ(conditions[1].kind, ConditionKind::displacement);
  ASSERT_EQ(conditions[1].expressions.size(), 2u);
  EXPECT_EQ(conditions[1].expressions[0]({0., 0.}), 2.);
  EXPECT_EQ(conditions[1].expressions[1]({0., 0.}), 0.25);
  EXPECT_EQ(conditions[2].kind, ConditionKind::pressure);
  EXPECT_EQ(conditions[2].expressions[0]({0., 0.}), 2.);
  EXPECT_TRUE(parse("").empty());
}

TEST(Condition, knows_points)
{
  const auto conditions = parse("(0, 1): displacement: 0, 0; (2*d, max(1, 2)): displacement y: d");
  ASSERT_EQ(conditions.size(), 2u);
  EXPECT_EQ(conditions[0].boundary, "(0, 1)");
  ASSERT_TRUE(conditions[0].point && conditions[1].point);
  EXPECT_EQ(*conditions[0].point, Vector2(0., 1.));
  EXPECT_EQ(*conditions[1].point, Vector2(0.5, 2.));
  EXPECT_FALSE(parse("left: displacement: 0, 0")[0].point);
}

TEST(Condition, resultants_have_one_component_or_two)
{
  EXPECT_EQ(parse("top: resultant: -4*d")[0].expressions.size(), 1u);
  EXPECT_EQ(parse("top: resultant: 0, -d")[0].expressions.size(), 2u);
  expect_phrase(condition_error("top: resultant: 1, 2, 3"),
                "`resultant` needs one (along the outward normal) or two expressions, received 3");
  expect_phrase(condition_error("top: resultant: x"), "here: top: the resultant `x` depends on x or y");
}

TEST(Condition, names_and_supports)
{
  for (const std::string kind :
       {"displacement x", "displacement y", "normal displacement", "tangential displacement", "resultant"})
  {
    const auto condition = parse("top: " + kind + ": 1")[0];
    EXPECT_EQ(to_string(condition.kind), kind);
    EXPECT_TRUE(is_support(condition.kind));
  }
  EXPECT_TRUE(is_support(parse("top: displacement: 1, 1")[0].kind));
  EXPECT_FALSE(is_support(parse("top: traction: 1, 1")[0].kind));
  EXPECT_FALSE(is_support(parse("top: pressure: 1")[0].kind));
}

TEST(Condition, refuses_what_it_cannot_read)
{
  expect_phrase(condition_error("left: 0"),
                "here: received `left: 0`, a condition is written id: kind: expressions");
  expect_phrase(condition_error(": pressure: 0"), "names no boundary");
  expect_phrase(condition_error("left: glue: 0"),
                "here: left: received `glue`, allowed are displacement, displacement x, "
                "displacement y, normal displacement, tangential displacement, traction, "
                "pressure, resultant");
  expect_phrase(condition_error("left: displacement: 0"), "`displacement` needs two expressions, received 1");
  expect_phrase(condition_error("left: pressure: 0, 1"), "`pressure` needs one expression, received 2");
  expect_phrase(condition_error("left: traction: 0, 1, 2"), "`traction` needs two expressions, received 3");
  expect_phrase(condition_error("left: pressure:"), "here: left: `` is not a formula: it is empty");
  expect_phrase(condition_error("left: pressure: e0"), "here: left: `e0` is not a formula");
}

TEST(Condition, refuses_points_that_are_none_or_carry_too_much)
{
  expect_phrase(condition_error("(0, 1: displacement: 0, 0"), "a point is written (x, y)");
  expect_phrase(condition_error("(0): displacement: 0, 0"), "a point is written (x, y)");
  expect_phrase(condition_error("(0, y): displacement: 0, 0"), "depends on x or y");
  expect_phrase(condition_error("(0, 1): pressure: 0"),
                "received `pressure` at a point, allowed are displacement, displacement x, displacement y");
}

TEST(Condition, refuses_the_same_kind_twice_in_one_place)
{
  expect_phrase(condition_error("top: pressure: 1; left: pressure: 1; top: pressure: 2"),
                "here: `top: pressure` is given twice");
  expect_phrase(condition_error("(0, 1): displacement x: 1; (0,4*d): displacement x: 2"), "is given twice");
  EXPECT_EQ(parse("top: displacement x: 1; top: displacement y: 1").size(), 2u);
}
