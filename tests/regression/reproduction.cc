// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `abut reproduce`: the figures of the paper's numerical example, in a shortened form.

#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cmath>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::project_file;
  using abut::testing::read_file;
  using abut::testing::run;

  Answer reproduce(const std::string &scene, const std::string &variants,
                   const std::vector<std::string> &options = {})
  {
    std::vector<std::string> arguments = {"reproduce", project_file("prm/" + scene + ".prm"), "--set",
                                          "Study/Variants=" + variants};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }

  void expect_svg(const std::string &path)
  {
    const std::string content = read_file(path), end = "</svg>\n";
    EXPECT_EQ(content.find("<?xml"), 0u) << path;
    ASSERT_GT(content.size(), end.size()) << path;
    EXPECT_EQ(content.substr(content.size() - end.size()), end) << path;
    EXPECT_EQ(content.find("nan"), std::string::npos) << path;
    EXPECT_LT(content.size(), 150000u) << path;
  }
} // namespace

TEST(Reproduction, TheCombinedAlgorithmEndsAfterAFewPassesAndRefinesTheContactZone)
{
  const Answer answer =
      reproduce("two-layers-paper", "0.2: Adaptation/Limit=0.2; 0.15: Adaptation/Limit=0.15");
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const std::string figure : {"figure04", "figure07", "figure08", "figure09", "figure10"})
    expect_svg(answer.directory + "/" + figure + ".svg");

  // The first run is the scene itself; the next one begins with pass 1 again.
  const std::string table = answer.directory + "/passes.csv";
  const std::vector<double> passes = column(table, "pass");
  const auto next = std::find(passes.begin() + 1, passes.end(), 1.);
  const auto last = static_cast<std::size_t>(next - passes.begin()) - 1;
  EXPECT_NEAR(passes[last], 6., 1.); // the paper's count is six
  EXPECT_LE(column(table, "eta")[last], .1);
  EXPECT_LE(column(table, "increment")[last], .0015);
  // The paper: "the adaptation of the mesh occurs in the contact zone". The body is of height 1, so that half
  // of the mean distance of its points is nearer than chance.
  const std::vector<double> level = column(table, "finest_level");
  for (std::size_t pass = 1; pass <= last; ++pass)
  {
    EXPECT_GE(level[pass], 1.) << pass;
    EXPECT_LT(column(table, "distance")[pass], .5 * column(table, "distance_of_all")[pass]) << pass;
  }
  // Exact contact of infinite layers: force 126.57 on the half model; six steps of gamma = 0.02 leave the
  // iteration some per cent away.
  EXPECT_NEAR(column(table, "force")[last], 126.574, .05 * 126.574);

  const std::vector<double> together = column(answer.directory + "/figure10.csv", "together"),
                            uniform = column(answer.directory + "/figure10.csv", "uniform");
  ASSERT_EQ(together.size(), 2u);
  for (std::size_t i = 0; i < together.size(); ++i)
    EXPECT_LT(together[i], uniform[i]);
}

TEST(Reproduction, ErrorsFallAndEstimatesAreCountedToTheirCost)
{
  const Answer answer =
      reproduce("two-layers-paper-errors",
                "fe-be: Adaptation/Estimator=fe-be | Adaptation/Marking=doerfler | Adaptation/Fraction=0.5",
                {"--set", "Adaptation/Maximum passes=3"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  expect_svg(answer.directory + "/errors.svg");
  const std::string table = answer.directory + "/errors.csv";
  const std::vector<double> energy = column(table, "true_error_energy"), fem = column(table, "fem"),
                            both = column(table, "fem_and_bem");
  ASSERT_EQ(energy.size(), 6u);
  for (const std::size_t pass : {1u, 2u, 4u, 5u})
    EXPECT_LT(energy[pass], energy[pass - 1]);
  EXPECT_NEAR(energy[2] / energy[1], .5, .05); // order 1, halved cells
  for (std::size_t pass = 0; pass < 6; ++pass)
    EXPECT_EQ(both[pass] > fem[pass], pass >= 3) << pass;
}

TEST(Reproduction, ASceneWithoutTheExactSolutionOfTheFiguresIsRefused)
{
  const Answer answer = reproduce(
      "two-layers-paper", "", {"--set", "Reference/Exact solution=none", "--set", "Adaptation/Limit=0.5"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_NE(answer.err.find("Reference/Exact solution"), std::string::npos) << answer.err;
}
