// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes with the estimator fe-be, run through the command line.

#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
  using abut::testing::Answer;
  using abut::testing::column;
  using abut::testing::expect_refused;
  using abut::testing::project_file;
  using abut::testing::read_file;
  using abut::testing::run;
  using abut::testing::run_scene;
  using abut::testing::with;
  using Overrides = std::vector<std::string>;

  const std::string fe_be = "Adaptation/Estimator=fe-be";
  const Overrides one_coarse_pass = {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                                     "Adaptation/Maximum passes=1"};

  double sum_over_passes(const Answer &answer, const std::string &key)
  {
    double sum = 0.;
    for (const auto &pass : answer.summary["pass_table"])
      sum += pass["cost"][key].get<double>();
    return sum;
  }
} // namespace

TEST(BoundaryElements, OnlyFeBeConstructsThem)
{
  for (const std::string estimator : {"kelly", "zz", "spr"})
  {
    const Answer answer =
        run_scene("two-layers-rollers", with(one_coarse_pass, {"Adaptation/Estimator=" + estimator}));
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string key : {"bem_models", "bem_elements", "bem_unknowns"})
      EXPECT_EQ(sum_over_passes(answer, key), 0.) << estimator << ' ' << key;
    EXPECT_EQ(answer.summary["time_s"]["bem"], 0.);
    EXPECT_NE(answer.summary["left_out"].dump().find("boundary elements"), std::string::npos);
  }
}

TEST(BoundaryElements, OneModelForEachMeshOfEachBody)
{
  const Answer answer =
      run_scene("two-layers-rollers", {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                                       "Body lower/Adapt=true", fe_be, "Adaptation/Maximum passes=3"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(sum_over_passes(answer, "bem_models"), 4.); // upper 1, lower 3
  EXPECT_EQ(answer.summary["pass_table"][0]["cost"]["bem_elements"], 2 * 40);
  EXPECT_GT(answer.summary["time_s"]["bem"].get<double>(), 0.);
  EXPECT_EQ(answer.summary["left_out"].dump().find("boundary elements"), std::string::npos);
}

TEST(BoundaryElements, MeshSizesStandInTheReport)
{
  const Answer answer = run_scene("two-layers-rollers", with(one_coarse_pass, {fe_be}));
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const auto &mesh : answer.summary["pass_table"][0]["meshes"])
  {
    EXPECT_NEAR(mesh["h_boundary"].get<double>(), .25, 1e-12);
    EXPECT_NEAR(mesh["h_max"].get<double>(), .25 * std::sqrt(2.), 1e-12);
    EXPECT_NEAR(mesh["h_ratio"].get<double>(), std::sqrt(.5), 1e-12);
    EXPECT_NEAR(mesh["regularity"].get<double>(), 1. + std::sqrt(2.), 1e-12);
  }
}

// Exact contact: the pressures applied push, and miss the law by what they meet of a gap.
TEST(BoundaryElements, BoundsTheErrorOfExactContact)
{
  const Answer answer =
      run_scene("two-layers-rollers",
                {fe_be, "Body upper/Cells=16, 4", "Body lower/Cells=16, 4", "Body upper/Adapt=true",
                 "Body lower/Adapt=true", "Adaptation/Maximum passes=5"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  for (const auto &pass : answer.summary["pass_table"])
  {
    const double bound = pass["error_total"], b = pass["error_discretisation"],
                 error = pass["true_error_energy"];
    EXPECT_GT(bound, error);
    EXPECT_LT(bound, 2. * error);
    EXPECT_NEAR(b / error, 1., .1);
    std::cout << "true error " << error << ", b " << b / error << ", bound " << bound / error << " of it\n";
  }
}

// b and the bound over the true error against the penalised solution, from the first step on.
TEST(BoundaryElements, BoundsTheErrorOfEveryStep)
{
  struct Case
  {
    std::string penalty, every;
  };
  for (const Case &c : {Case{"0.05", "1"}, Case{"5e-4", "20"}})
  {
    const Answer answer = run_scene(
        "two-layers-rollers",
        with(one_coarse_pass,
             {fe_be, "Decomposition/Scheme=neumann", "Contact interface/Penalty coefficient=" + c.penalty,
              "Adaptation/Estimate steps=" + c.every, "Reference/Contact=penalised",
              "Decomposition/Tolerance=1e-3", "Adaptation/Iteration fraction=0"}));
    ASSERT_EQ(answer.status, 0) << answer.err;
    const std::string history = answer.directory + "/history.csv";
    const std::vector<double> b = column(history, "step_discretisation_ratio"),
                              bound = column(history, "step_bound_ratio");
    std::size_t n_estimates = 0;
    for (const double ratio : bound)
      if (std::isfinite(ratio))
      {
        EXPECT_GT(ratio, 1.) << "penalty " << c.penalty;
        ++n_estimates;
      }
    EXPECT_GT(n_estimates, 20u);
    const auto &pass = answer.summary["pass_table"].back();
    const double exact = pass["true_error_energy"];
    EXPECT_NEAR(pass["error_discretisation"].get<double>() / exact, 1., .1) << "penalty " << c.penalty;
    EXPECT_LT(pass["error_total"].get<double>() / exact, 1.6) << "penalty " << c.penalty;
    EXPECT_EQ(sum_over_passes(answer, "bem_models"), 2.); // made by the first step, kept by the others
    // Far from the limit b tells of the iteration.
    EXPECT_TRUE(std::any_of(b.begin(), b.end(), [](const double ratio) { return ratio > 5.; }));
  }
}

TEST(BoundaryElements, TheBetterStressIsWrittenOut)
{
  const Answer answer = run_scene("two-layers-rollers", with(one_coarse_pass, {fe_be}));
  ASSERT_EQ(answer.status, 0) << answer.err;
  const std::string vtu = read_file(answer.directory + "/solution_lower.vtu");
  for (const std::string name : {"better_stress_xx", "better_von_mises", "\"eta\""})
    EXPECT_NE(vtu.find(name), std::string::npos) << name;
  const auto &whole = answer.summary["pass_table"][0]["estimator"]["whole"];
  EXPECT_LT(whole["better_error"].get<double>(), .15 * whole["computed_error"].get<double>());
}

TEST(BoundaryElements, RefuseWhatTheyCannotSolve)
{
  expect_refused(
      run({project_file("prm/shrink-fit.prm"), "--set", fe_be, "--set", "Discretisation/Degree=2"}),
      {"Degree = 2", "curved sides", "fe-be"});
  expect_refused(run({project_file("prm/two-layers-rollers.prm"), "--set", fe_be, "--set",
                      "Body lower/Body force=0, -x", "--set", "Reference/Exact solution=none"}),
                 {"Body lower", "Body force = -x", "not uniform"});
}
