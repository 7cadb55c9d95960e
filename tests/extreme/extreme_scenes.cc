// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Stiff, nearly incompressible, tiny and huge scenes: right results, or a message; never nonsense.

#include <gtest/gtest.h>

#include "../regression/program.h"
#include <cmath>
#include <iostream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::run_scene;

  Answer patch(const std::vector<std::string> &overrides)
  {
    return run_scene("patch-test", overrides);
  }

  /// p = Delta/(sum (1 - nu^2) H/E + theta), theta = (c/2) sum H/E, for blocks of height 1 and approach 1e-3.
  double patch_pressure(const double e1, const double nu1, const double e2, const double nu2, const double c)
  {
    return 1e-3 / ((1. - nu1 * nu1) / e1 + (1. - nu2 * nu2) / e2 + .5 * c * (1. / e1 + 1. / e2));
  }

  void expect_uniform(const Answer &answer, const double exact, const double largest_residual = 1e-10)
  {
    ASSERT_EQ(answer.status, 0) << answer.err;
    double largest = 0.;
    for (const double pressure : column(answer.directory + "/contact_interface.csv", "pressure"))
      largest = std::max(largest, std::abs(pressure / exact - 1.));
    EXPECT_LT(largest, 1e-9);
    for (const auto &body : answer.summary["bodies"])
      EXPECT_LT(body["equilibrium_residual"].get<double>(), largest_residual);
    std::cout << "largest relative deviation of the pressure " << largest << '\n';
  }
} // namespace

TEST(Extreme, StiffnessContrastOfAMillionMillion)
{
  expect_uniform(patch({"Body upper/Young modulus=1e8", "Body lower/Young modulus=1e-4"}),
                 patch_pressure(1e8, .3, 1e-4, .3, .05));
}

TEST(Extreme, NearlyIncompressible)
{
  // The layers of the initial guess are stiff without end here: the first steps only let its pressure decay.
  // Forces are differences of products with lambda = 5e6 mu: round-off leaves some 5e6 times 2e-16 of them.
  expect_uniform(patch({"Body upper/Poisson ratio=0.4999999", "Body lower/Poisson ratio=0.4999999"}),
                 patch_pressure(100., .4999999, 100., .4999999, .05), 5e-9);
}

TEST(Extreme, NegativePoissonRatio)
{
  expect_uniform(patch({"Body upper/Poisson ratio=-0.9"}), patch_pressure(100., -.9, 100., .3, .05));
}

TEST(Extreme, MicrometresAndKilometres)
{
  for (const std::string scale : {"1e-6", "1e6"})
    expect_uniform(
        patch({"Body upper/Scale=" + scale, "Body lower/Scale=" + scale, "Body upper/Shift=0, " + scale}),
        patch_pressure(100., .3, 100., .3, .05));
}

TEST(Extreme, NumbersNearTheEndsOfTheRange)
{
  for (const std::string modulus : {"1e-100", "1e100"})
    expect_uniform(patch({"Body upper/Young modulus=" + modulus, "Body lower/Young modulus=" + modulus}),
                   patch_pressure(std::stod(modulus), .3, std::stod(modulus), .3, .05));
}

TEST(Extreme, ARigidBody)
{
  expect_uniform(patch({"Body upper/Young modulus=1e300"}), patch_pressure(1e300, .3, 100., .3, .05));
}

TEST(Extreme, FlatCells)
{
  expect_uniform(patch({"Body upper/Cells=3, 300", "Body lower/Cells=200, 2"}),
                 patch_pressure(100., .3, 100., .3, .05));
}

TEST(Extreme, ApartAndNeverTouching)
{
  const Answer answer = patch({"Contact interface/Gap=0.5"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["contacts"][0]["normal_force"], 0.);
  EXPECT_EQ(answer.summary["contacts"][0]["contact_length"], 0.);
  EXPECT_EQ(answer.summary["status"], "converged");
}

TEST(Extreme, ATolerancePastRoundOffEndsWithAMessage)
{
  const Answer answer = patch({"Decomposition/Tolerance=1e-30"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("round-off"), std::string::npos) << answer.err;
  EXPECT_EQ(answer.summary["status"], "not converged");
}

TEST(Extreme, AForceThatNothingCarries)
{
  // The upper block is pulled up, but contact cannot hold it down.
  const Answer answer = patch({"Body upper/Conditions=left: normal displacement: 0; top: resultant: 0, 5"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("no displacement of the rigid side carries the force"), std::string::npos)
      << answer.err;
  EXPECT_TRUE(answer.summary.is_null());
}

TEST(Extreme, AForceIsCarriedWhateverTheStiffness)
{
  for (const std::string modulus : {"1e-3", "1e6"})
  {
    const Answer answer = patch({"Body upper/Conditions=left: normal displacement: 0; top: resultant: 0, -7",
                                 "Body upper/Young modulus=" + modulus});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_NEAR(answer.summary["contacts"][0]["normal_force"].get<double>(), 7., 7e-9);
  }
}
