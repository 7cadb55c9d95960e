// SPDX-License-Identifier: LGPL-2.1-or-later
//
// error.total: that it bounds, and where it is called an estimate because it may not.
#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <iostream>

using namespace abut::testing;

namespace
{
  const std::string by_boundary_elements = "Adaptation/Estimator=fe-be";

  void expect_estimate(const Answer &answer, const std::string &reason)
  {
    ASSERT_EQ(answer.status, 0) << answer.err;
    const nlohmann::json &error = answer.summary["error"];
    EXPECT_FALSE(error["error_is_bound"].get<bool>());
    EXPECT_NE(error["estimate_reason"].get<std::string>().find(reason), std::string::npos)
        << error["estimate_reason"];
    EXPECT_EQ(answer.summary["pass_table"].back()["error_is_bound"], error["error_is_bound"]);
    EXPECT_NE(answer.out.find("an estimate and no bound: "), std::string::npos);
  }
} // namespace

// A slave sixteen times finer than the master: half of the error is in what the master's trace cannot carry.
TEST(ErrorBound, FineSlaveOnACoarseMaster)
{
  const Answer answer = run_case("bound-fine-slave");
  ASSERT_EQ(answer.status, 0) << answer.err;
  const nlohmann::json &error = answer.summary["error"];
  EXPECT_TRUE(error["error_is_bound"].get<bool>());
  EXPECT_EQ(error["estimate_reason"], "");
  const double ratio = error["effectivity_total"];
  std::cout << "bound by true error " << ratio << '\n';
  EXPECT_GE(ratio, .97);
  EXPECT_LE(ratio, 2.);
}

// Elements that lock answer with stresses that are wrong and large: the error is up to 170 % of the exact
// solution, and the bound, relative to that and not to the wrong response, passes 100 %.
TEST(ErrorBound, IsNotMadeSmallByALockedResponse)
{
  for (const std::string cells : {"8, 2", "16, 4", "32, 8"})
  {
    std::vector<std::string> overrides = {by_boundary_elements};
    for (const std::string body : {"upper", "lower"})
      for (const std::string &entry : {"Cells=" + cells, std::string("Cell type=triangles"),
                                       std::string("Poisson ratio=.4999"), std::string("Allow locking=true")})
        overrides.push_back("Body " + body + "/" + entry);
    const Answer answer = run_scene("two-layers-rollers", overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double error = answer.summary["true_error"]["energy"], total = answer.summary["error"]["total"];
    std::cout << cells << " triangles, nu = .4999: error " << error << ", bound " << total << '\n';
    EXPECT_GT(error, 1.);
    EXPECT_GE(total, error);
  }
}

TEST(ErrorBound, IsAnEstimateWhereContactReachesAnEdge)
{
  expect_estimate(run_case("edge-dropping", {by_boundary_elements}), "reaches an edge");
  // One cell from the plane of symmetry to the edge.
  expect_estimate(
      run_scene("patch-test", {by_boundary_elements, "Body upper/Cells=1, 1",
                               "Body upper/Conditions=left: normal displacement: 0; top: pressure: 1",
                               "Body lower/Conditions=left: normal displacement: 0; bottom: "
                               "normal displacement: 0; right: normal displacement: 0"}),
      "reaches an edge");
}

TEST(ErrorBound, IsAnEstimateOnCurvedSides)
{
  expect_estimate(run_scene("hertz", {by_boundary_elements, "Discretisation/Degree=1"}),
                  "curved sides of body");
}

TEST(ErrorBound, IsAnEstimateForOtherEstimators)
{
  for (const std::string estimator : {"kelly", "zz", "spr"})
    expect_estimate(run_scene("two-layers-rollers", {"Adaptation/Estimator=" + estimator}),
                    "only Estimator = fe-be");
  expect_estimate(run_scene("two-layers-rollers",
                            {by_boundary_elements, "Adaptation/Boundary solution=constant traction"}),
                  "Boundary solution");
}

TEST(ErrorBound, IsAnEstimateForNearlyIncompressibleBodies)
{
  expect_estimate(run_scene("two-layers-rollers", {by_boundary_elements, "Body lower/Poisson ratio=.45"}),
                  "nearly incompressible body lower");
}
