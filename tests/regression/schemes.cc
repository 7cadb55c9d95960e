// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `abut schemes`.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

using namespace abut::testing;

namespace
{
  Answer compare(const std::string &scene, const std::vector<std::string> &overrides = {})
  {
    std::vector<std::string> arguments = {"schemes", project_file("prm/" + scene + ".prm")};
    for (const std::string &override : overrides)
      arguments.insert(arguments.end(), {"--set", override});
    return run(arguments);
  }

  enum Row : std::size_t
  {
    newton,
    conjugate,
    neumann
  };
} // namespace

TEST(Schemes, AllComeAsNearAsTheySay)
{
  const Answer answer = compare("two-layers-rollers", {"Contact interface/Penalty coefficient=5e-2"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const std::string file = answer.directory + "/schemes.csv";
  const auto steps = column(file, "steps"), solves = column(file, "solves"),
             error = column(file, "error_iteration"), distance = column(file, "distance"),
             predicted = column(file, "predicted_steps");
  ASSERT_EQ(steps.size(), 3u);
  for (const Row row : {newton, conjugate, neumann})
  {
    EXPECT_LE(error[row], 1e-6);
    EXPECT_LE(distance[row], error[row] + 1e-12);
    EXPECT_GT(solves[row], 0.);
  }
  EXPECT_GT(distance[neumann], 1e-9); // and not by another way
  EXPECT_LE(steps[newton], 10.);
  EXPECT_LE(steps[conjugate], 40.);
  EXPECT_GT(steps[neumann], 100.);
  EXPECT_LE(steps[neumann], predicted[neumann]);
  EXPECT_GE(steps[neumann], .5 * predicted[neumann]);
}

TEST(Schemes, WhatIsNotRunIsPredictedOrSaysWhy)
{
  const Answer tiny = compare("two-layers-rollers", {"Contact interface/Penalty coefficient=1e-6"});
  ASSERT_EQ(tiny.status, 0) << tiny.err;
  EXPECT_NE(tiny.out.find("neumann: not run: too many steps"), std::string::npos) << tiny.out;
  const std::string file = tiny.directory + "/schemes.csv";
  EXPECT_TRUE(std::isnan(column(file, "steps")[neumann]));
  // ln(tol)/ln(1 - gamma) with gamma about 2 theta/mu: in proportion to 1/c.
  const Answer less_tiny = compare("two-layers-rollers", {"Contact interface/Penalty coefficient=1e-5"});
  EXPECT_NEAR(column(file, "predicted_steps")[neumann] /
                  column(less_tiny.directory + "/schemes.csv", "predicted_steps")[neumann],
              10., .01);

  EXPECT_NE(compare("two-layers-rollers").out.find("neumann: not run: the contact interface has no penalty"),
            std::string::npos);
  EXPECT_NE(compare("v-groove").out.find("neumann: not run: contact alone holds the body disc"),
            std::string::npos);
  EXPECT_NE(compare("hertz").out.find("neumann: not run: the body roller carries a given force"),
            std::string::npos);
}

TEST(Schemes, AnUnreachedToleranceEndsWithStatusTwo)
{
  const Answer answer = compare("two-layers-rollers", {"Decomposition/Maximum steps=3"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.out.find("conjugate: The scheme conjugate has not reached the tolerance within"),
            std::string::npos)
      << answer.out;
  const std::string file = answer.directory + "/schemes.csv";
  EXPECT_EQ(column(file, "converged")[conjugate], 0.);
  EXPECT_GT(column(file, "distance")[conjugate], 1e-4);
}

TEST(Schemes, WrongConditionsAreRefusedAsInARun)
{
  const std::string exact = "Body lower/Conditions=left: normal displacement: 0; bottom: displacement: exact";
  const Answer compared = compare("two-layers-rollers", {exact}),
               run_alone = run_scene("two-layers-rollers", {exact});
  expect_refused(compared, {"two-layers-rollers.prm"});
  EXPECT_EQ(compared.err, run_alone.err);
}

TEST(Schemes, WhatIsRefusedLeavesNothing)
{
  expect_refused(compare("pile-of-discs", {"Body top/Body force=0.001*y, -3"}),
                 {"Body top", "no contact resists this motion"});
}

TEST(Schemes, ASceneWithoutContactIsRefused)
{
  expect_refused(compare("corner"), {"corner.prm: Contacts", "schemes are compared on contacts"});
}
