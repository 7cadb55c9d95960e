// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Uniform pressure goes through meshes that do not match, and the supports carry what the contact transmits.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <iostream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::run_scene;

  struct Patch
  {
    std::string name;
    std::vector<std::string> overrides;
  };

  const std::vector<std::string> turned = {"Body upper/Rotation angle=30", "Body lower/Rotation angle=30",
                                           "Body upper/Shift=-0.5, 0.86602540378443864676"};

  std::vector<std::string> cells(const std::string &upper, const std::string &lower,
                                 std::vector<std::string> more = {})
  {
    more.insert(more.end(), {"Body upper/Cells=" + upper, "Body lower/Cells=" + lower});
    return more;
  }

  class PatchTest : public ::testing::TestWithParam<Patch>
  {};

  TEST_P(PatchTest, PressureIsUniform)
  {
    const Answer answer = run_scene("patch-test", GetParam().overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double exact = 1e-3 / (2. * (1. - .3 * .3) / 100. + .05 / 100.);
    double largest = 0.;
    for (const double pressure : column(answer.directory + "/contact_interface.csv", "pressure"))
      largest = std::max(largest, std::abs(pressure / exact - 1.));
    EXPECT_LT(largest, 1e-9);
    std::cout << GetParam().name << ": largest relative deviation of the pressure " << largest << '\n';
  }

  INSTANTIATE_TEST_SUITE_P(
      Meshes, PatchTest,
      ::testing::Values(Patch{"two_to_three", cells("2, 2", "3, 3")},
                        Patch{"five_to_seven", cells("5, 4", "7, 3")},
                        Patch{"two_to_three_turned", cells("2, 2", "3, 3", turned)},
                        Patch{"five_to_seven_turned", cells("5, 4", "7, 3", turned)},
                        Patch{"coarse_slave_turned", cells("7, 3", "5, 4", turned)},
                        Patch{"degree_two_turned", cells("5, 4", "7, 3",
                                                         [] {
                                                           auto overrides = turned;
                                                           overrides.emplace_back("Discretisation/Degree=2");
                                                           return overrides;
                                                         }())},
                        Patch{"degree_three_against_one",
                              cells("5, 4", "7, 3", {"Body upper/Degree=3", "Body lower/Degree=1"})},
                        Patch{"triangles", cells("5, 4", "7, 3", {"Body upper/Cell type=triangles"})}),
      [](const auto &parameter) { return parameter.param.name; });

  /// Forces of the supports, of the contact and of the loads on every body.
  class Balance : public ::testing::TestWithParam<std::string>
  {};

  TEST_P(Balance, ReactionsCarryTheContact)
  {
    const Answer answer = run_scene(GetParam());
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const auto &body : answer.summary["bodies"])
    {
      EXPECT_LT(body["equilibrium_residual"].get<double>(), 1e-10) << body["name"];
      std::cout << GetParam() << ", " << body["name"] << ": equilibrium residual "
                << body["equilibrium_residual"] << '\n';
    }
  }

  INSTANTIATE_TEST_SUITE_P(Scenes, Balance,
                           ::testing::Values("two-layers", "two-layers-bonded", "two-layers-rollers",
                                             "patch-test", "three-bodies", "shrink-fit", "hertz"),
                           [](const auto &parameter) {
                             std::string name = parameter.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                           });

  TEST(ThreeBodies, TheGivenForceIsCarried)
  {
    const Answer answer = run_scene("three-bodies");
    ASSERT_EQ(answer.status, 0) << answer.err;
    const auto &contacts = answer.summary["contacts"];
    EXPECT_NEAR(contacts[1]["normal_force"].get<double>(), 60., 60. * 2e-5);
    // What both punches exert arrives at the bottom of the foundation.
    const double bottom = answer.summary["bodies"][2]["reactions"]["bottom"][1];
    EXPECT_NEAR(bottom, contacts[0]["normal_force"].get<double>() + contacts[1]["normal_force"].get<double>(),
                1e-8);
  }
} // namespace
