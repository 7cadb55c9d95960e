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
  using abut::testing::expect_refused;
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

// What a run is to a figure follows from its parameters: the names of variants are for people.
TEST(Reproduction, TheFiguresDoNotDependOnTheNamesOfVariants)
{
  const std::string parameters[] = {"Adaptation/Limit=0.4", "Adaptation/Limit=0.3",
                                    "Adaptation/Normalisation=rms | Adaptation/Limit=0.35",
                                    "Adaptation/Combined=false | Adaptation/Estimator=none | "
                                    "Adaptation/Limit=0 | Body lower/Adapt=false"};
  const auto answer_of = [&](const std::vector<std::string> &names) {
    std::string variants;
    for (std::size_t i = 0; i < names.size(); ++i)
      variants += (i == 0 ? "" : "; ") + names[i] + ": " + parameters[i];
    return reproduce("two-layers-paper", variants, {"--set", "Adaptation/Limit=0.5"});
  };
  const Answer plain = answer_of({"0.4", "0.3", "other", "limit"});
  const Answer renamed = answer_of({"limit", "0.7", "0.2", "last"});
  ASSERT_EQ(plain.status, 0) << plain.err;
  ASSERT_EQ(renamed.status, 0) << renamed.err;
  EXPECT_EQ(column(plain.directory + "/figure08.csv", "delta"), (std::vector<double>{.4, .3}));
  for (const std::string file : {"figure08.csv", "figure08.svg", "figure10.csv", "figure10.svg"})
    EXPECT_EQ(read_file(plain.directory + "/" + file), read_file(renamed.directory + "/" + file)) << file;
  for (const std::string name : {"pass", "cells", "eta", "force", "u_1", "u_2"})
  {
    const std::vector<double> first = column(plain.directory + "/passes.csv", name),
                              second = column(renamed.directory + "/passes.csv", name);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_TRUE(first[i] == second[i] || (std::isnan(first[i]) && std::isnan(second[i]))) << name << i;
  }
  const auto figures = [](const Answer &answer) { return answer.out.substr(answer.out.find("  delta")); };
  const auto shown = [&](const Answer &answer) {
    return figures(answer).substr(0, figures(answer).find("  Figures and data in"));
  };
  EXPECT_EQ(shown(plain), shown(renamed));
  EXPECT_NE(shown(plain).find("limit of the iteration"), std::string::npos);
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

TEST(Reproduction, TrueErrorsNeedASolutionWithAStress)
{
  for (const std::string scene : {"hertz", "disc-between-plates"})
    expect_refused(reproduce(scene, ""), {"Reference/Exact solution: received `", "with a stress"});
}
