// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/goal_marks.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace abut;

namespace
{
  Eigen::VectorXd squares(const std::initializer_list<double> values)
  {
    Eigen::VectorXd vector(values.size());
    std::copy(values.begin(), values.end(), vector.data());
    return vector;
  }

  TEST(GoalMarks, TakeTheLargestErrorsOfAllBodiesUntilTheAimIsExpected)
  {
    // 16 of 20 have to go: splitting keeps an eighth of degree 2, 8 + 6 + 4 are needed for 15.75.
    const GoalMarks marks =
        goal_marks({{squares({8., 1.}), 2, true}, {squares({4., 6., 1.}), 2, true}}, std::sqrt(4.3 / 20.));
    EXPECT_EQ(marks.cells[0].refine, (std::vector<bool>{true, false}));
    EXPECT_EQ(marks.cells[1].refine, (std::vector<bool>{true, true, false}));
    EXPECT_EQ(marks.n_split, (std::vector<std::size_t>{1, 2}));
    EXPECT_NEAR(marks.expected, std::sqrt((20. - 18. * .875) / 20.), 1e-12);
  }

  TEST(GoalMarks, NoMoreThanNineTenthsOfTheSquaredError)
  {
    const GoalMarks marks = goal_marks({{squares({60., 31., 6., 3.}), 3, true}}, 0.);
    EXPECT_EQ(marks.cells[0].refine, (std::vector<bool>{true, true, false, false}));
  }

  TEST(GoalMarks, NothingWhereTheAimIsReached)
  {
    const GoalMarks marks = goal_marks({{squares({9., 1.}), 1, true}}, 1.);
    EXPECT_EQ(marks.n_split[0], 0u);
    EXPECT_EQ(marks.expected, 1.);
  }

  TEST(GoalMarks, TreatEqualErrorsAlike)
  {
    const GoalMarks marks = goal_marks({{squares({1., 1., 1. + 1e-9, 1.}), 1, true}}, .9);
    EXPECT_EQ(marks.n_split[0], 4u);
  }

  TEST(GoalMarks, LeaveBodiesThatDoNotAdapt)
  {
    const GoalMarks marks = goal_marks({{squares({9.}), 1, false}, {squares({1.}), 1, true}}, .5);
    EXPECT_EQ(marks.n_split, (std::vector<std::size_t>{0, 1}));
    EXPECT_GT(marks.expected, .9); // the error of the first body stays
  }

  TEST(GoalMarks, NothingWithoutErrors)
  {
    const GoalMarks marks = goal_marks({{squares({0., 0.}), 1, true}}, .5);
    EXPECT_EQ(marks.n_split[0], 0u);
    EXPECT_EQ(marks.expected, 0.);
  }
} // namespace
