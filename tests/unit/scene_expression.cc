// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/expression.h>

#include "scene_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  const Constants constants{{"r0", 1e-3}, {"H", 2.}};

  double value(const std::string &text, const Vector2 &point)
  {
    return Expression(text, constants, "here")(point);
  }

  std::string expression_error(const std::string &text)
  {
    return message_of([&] { Expression(text, constants, "here"); });
  }
} // namespace

TEST(Expression, knows_coordinates_constants_and_pi)
{
  EXPECT_DOUBLE_EQ(value("r0*x^2 + H*y", {3., 5.}), 9e-3 + 10.);
  EXPECT_DOUBLE_EQ(value("sin(pi*x)", {0.25, 0.}), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(value(" -H ", {0., 0.}), -2.);
}

TEST(Expression, decides_with_if)
{
  EXPECT_EQ(value("if(x<1, 3, y)", {0.5, 7.}), 3.);
  EXPECT_EQ(value("if (x < 1, 3, y)", {1.5, 7.}), 7.);
  EXPECT_EQ(value("x==1 ? 2 : 4", {1., 0.}), 2.);
  EXPECT_EQ(value("if(x>=1, if(x!=2, 5, 6), 7)", {2., 0.}), 6.);
}

TEST(Expression, refuses_at_once_what_is_no_formula)
{
  for (const std::string text : {"", "x +", "sin(x", "z", "if(x<1, unknown, 2)", "1, 2", "1; 2", "x = 3"})
    expect_phrase(expression_error(text), "here: `" + text + "` is not a formula: ");
  expect_phrase(expression_error("q*x"),
                "`q*x` is not a formula: Unexpected token \"q\" found at position 0");
  expect_phrase(expression_error("1, 2"), "comma outside parentheses");
  expect_phrase(expression_error("if(x=1, 2, 3)"), "== compares");
}

TEST(Expression, prints_nothing_of_its_own_about_an_error)
{
  testing::internal::CaptureStderr();
  expression_error("z");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Expression, refuses_values_that_are_not_finite_only_where_they_arise)
{
  const Expression inverse("1/x", constants, "here");
  EXPECT_EQ(inverse({2., 0.}), 0.5);
  expect_phrase(message_of([&] { inverse({0., 0.}); }), "here: `1/x` has no finite value at (0");
  expect_phrase(message_of([&] { value("sqrt(y)", {0., -1.}); }), "no finite value");
}

TEST(Expression, tells_constants_from_fields)
{
  const auto is_constant = [](const std::string &text) {
    return Expression(text, {{"xa", 1.}, {"y2", 1.}}, "here").is_constant();
  };
  EXPECT_TRUE(is_constant("xa + y2*exp(1) + max(1, 2)"));
  EXPECT_FALSE(is_constant("xa + y2*x"));
  EXPECT_FALSE(is_constant("y"));
  EXPECT_FALSE(is_constant("if(y<1,xa,y2)"));
  EXPECT_EQ(constant_value("-H/4", constants, "here"), -0.5);
  expect_phrase(message_of([] { constant_value("H*x", constants, "here"); }), "depends on x or y");
}
