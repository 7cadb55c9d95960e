// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The paper's scene, doc/method.md, on 64 x 16 cells in both bodies. The figures compared with
// were computed with an independent prototype before this code existed.

#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::project_file;
  using abut::testing::run;

  const std::vector<std::string> by_the_bound = {
      "--set", "Decomposition/Stopping rule=bound",
      "--set", "Decomposition/Tolerance=1e-6",
      "--set", "Decomposition/Initial guess=elastic layer response"};

  Answer two_layers(std::vector<std::string> options)
  {
    options.insert(options.begin(), project_file("prm/two-layers.prm"));
    return run(options);
  }

  std::vector<std::string> with(std::vector<std::string> options, const std::string &override)
  {
    options.insert(options.end(), {"--set", override});
    return options;
  }
} // namespace

TEST(PaperScene, PaperRuleStopsAfterFiveStepsSixPercentFromTheLimit)
{
  const Answer answer = two_layers({});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["stopped_by"], "increment");
  EXPECT_NEAR(answer.summary["steps"].get<int>(), 5, 1);
  EXPECT_NEAR(answer.summary["iteration"]["limit_distance"]["displacement"].get<double>(), .06, .01);
  EXPECT_NE(answer.out.find("% from the limit"), std::string::npos) << answer.out;
  std::cout << "steps " << answer.summary["steps"] << ", contact displacement "
            << answer.summary["iteration"]["limit_distance"]["displacement"] << " from the limit\n";
}

TEST(PaperScene, FourStepsOnTheCoarserMesh)
{
  const Answer answer = two_layers({"--set", "Body upper/Cells=32, 8", "--set", "Body lower/Cells=32, 8"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NEAR(answer.summary["steps"].get<int>(), 4, 1);
}

TEST(PaperScene, PeakPressureByTheBound)
{
  const Answer answer = two_layers(by_the_bound);
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["stopped_by"], "bound");
  EXPECT_NEAR(answer.summary["contacts"][0]["max_pressure"].get<double>(), 161.5, 1.615);
  EXPECT_LE(answer.summary["error"]["iteration"].get<double>(), 1e-6);
  EXPECT_GT(answer.summary["steps"].get<int>(), 480 - 1);
  EXPECT_LT(answer.summary["steps"].get<int>(), 520);
  std::cout << "steps " << answer.summary["steps"] << ", peak pressure "
            << answer.summary["contacts"][0]["max_pressure"] << " MPa\n";
}

TEST(PaperScene, TheBoundNeverGrows)
{
  const Answer answer = two_layers(by_the_bound);
  const std::vector<double> bound = column(answer.directory + "/history.csv", "error_iteration");
  ASSERT_GT(bound.size(), 100u);
  for (std::size_t i = 1; i < bound.size(); ++i)
    // The bound is relative to the present displacement, whose norm changes little.
    EXPECT_LE(bound[i], bound[i - 1] * (1. + 1e-6)) << "step " << i + 1;
}

TEST(PaperScene, TooLargeGammaEndsWithStatusTwoAndNamesItsLimit)
{
  const Answer answer = two_layers(with(by_the_bound, "Decomposition/Relaxation=0.1"));
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("gamma* = 0.0535"), std::string::npos) << answer.err;
  EXPECT_EQ(answer.summary["status"], "not converged");
  EXPECT_EQ(answer.summary["stopped_by"], "stalled");
}

TEST(PaperScene, TheLimitOfGammaIsSharp)
{
  // With the final contact gamma* is 0.0567: 0.056 still converges, 0.058 does not.
  EXPECT_EQ(two_layers(with(by_the_bound, "Decomposition/Relaxation=0.056")).status, 0);
  EXPECT_EQ(two_layers(with(by_the_bound, "Decomposition/Relaxation=0.058")).status, 2);
}

TEST(PaperScene, TheIncrementRuleDoesNotPassADivergingRun)
{
  const Answer answer = two_layers({"--set", "Decomposition/Relaxation=0.1"});
  EXPECT_EQ(answer.status, 2) << "stopped by " << answer.summary["stopped_by"];
}

TEST(PaperScene, AutomaticGammaConverges)
{
  const Answer answer = two_layers(with(by_the_bound, "Decomposition/Relaxation=automatic"));
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_NEAR(answer.summary["contacts"][0]["max_pressure"].get<double>(), 161.6, .1);
  EXPECT_NEAR(answer.summary["relaxation"].get<double>(), 2. / (1. + 37.4), 2e-4);
}

TEST(PaperScene, TheMatrixAndTheSolvesGiveTheSameIterates)
{
  const auto short_run = with(by_the_bound, "Decomposition/Maximum steps=60");
  const Answer dense = two_layers(with(short_run, "Decomposition/Interface compliance=dense"));
  const Answer solves = two_layers(with(short_run, "Decomposition/Interface compliance=solves"));
  for (const std::string name : {"error_iteration", "max_pressure", "normal_force"})
  {
    const auto a = column(dense.directory + "/history.csv", name);
    const auto b = column(solves.directory + "/history.csv", name);
    ASSERT_EQ(a.size(), 60u);
    ASSERT_EQ(b.size(), 60u);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-9 * std::abs(a[i])) << name << " at step " << i + 1;
  }
}

TEST(PaperScene, BondedFacesAndTrianglesRun)
{
  // The infinite bonded layer in exact contact: p(0) = 193.527 MPa, force 150.320; a tenth of the paper's
  // penalty takes a tenth of its three per cent, the finite length 2e-4.
  const Answer bonded =
      abut::testing::run_scene("two-layers-bonded", {"Contact interface/Penalty coefficient=0.005"});
  ASSERT_EQ(bonded.status, 0) << bonded.err;
  EXPECT_NEAR(bonded.summary["contacts"][0]["max_pressure"].get<double>(), 193.527, .005 * 193.527);
  EXPECT_NEAR(bonded.summary["contacts"][0]["normal_force"].get<double>(), 150.320, .005 * 150.320);
  const Answer triangles = two_layers(
      with(with(by_the_bound, "Body upper/Cell type=triangles"), "Decomposition/Relaxation=automatic"));
  ASSERT_EQ(triangles.status, 0) << triangles.err;
  EXPECT_NEAR(triangles.summary["contacts"][0]["max_pressure"].get<double>(), 161.6, .01 * 161.6);
}

TEST(PaperScene, NothingIsDoneTwiceOrInVain)
{
  const Answer answer = two_layers(by_the_bound);
  const auto &counters = answer.summary["counters"];
  for (const std::string body : {"upper", "lower"})
  {
    EXPECT_EQ(counters["bodies"][body]["meshes"], 1);
    EXPECT_EQ(counters["bodies"][body]["assemblies"], 1);
    EXPECT_EQ(counters["bodies"][body]["factorisations"], 1);
  }
  EXPECT_EQ(counters["mpi_initialised"], false);
  EXPECT_EQ(counters["p4est_initialised"], false);
}
