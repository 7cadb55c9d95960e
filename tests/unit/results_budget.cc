// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/error_budget.h>

#include <gtest/gtest.h>

using namespace abut;

namespace
{
  TEST(ErrorBudget, SumsItsParts)
  {
    ErrorBudget budget;
    EXPECT_FALSE(budget.estimate());
    EXPECT_FALSE(budget.bound());
    budget.discretisation = .03;
    budget.contact = .04;
    EXPECT_DOUBLE_EQ(*budget.estimate(), .05);
    EXPECT_FALSE(budget.bound());
    budget.bounded_part = .06;
    budget.penalty = .12;
    budget.linear_algebra = .001;
    budget.geometry = .002;
    EXPECT_DOUBLE_EQ(*budget.bound(), .183);
    EXPECT_NEAR(*budget.estimate(), .13, 1e-4);
    EXPECT_STREQ(budget.dominant().name, "penalty");
  }
} // namespace
