// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The paper's combined algorithm, one step of the decomposition and one of the adaptation a pass, through the
// command line.

#include <gtest/gtest.h>

#include "program.h"

using namespace abut::testing;

namespace
{
  std::vector<std::string> combined_spr(const std::string &limit, const int passes)
  {
    return {"Body upper/Adapt=true",
            "Body lower/Adapt=true",
            "Adaptation/Estimator=spr",
            "Adaptation/Combined=true",
            "Adaptation/Limit=" + limit,
            "Adaptation/Marking=threshold",
            "Adaptation/Maximum passes=" + std::to_string(passes)};
  }
} // namespace

TEST(Combined, EndsWhenBothTestsHold)
{
  // The paper's scene and parameters, its body 2 adapting; the literal guess and the increment rule.
  const std::vector<std::string> combined = {"Body lower/Adapt=true",       "Body lower/Cells=16, 4",
                                             "Adaptation/Estimator=zz",     "Adaptation/Combined=true",
                                             "Adaptation/Limit=0.3",        "Adaptation/Marking=threshold",
                                             "Adaptation/Maximum passes=60"};
  const Answer answer = run_scene("two-layers", combined);
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.summary["stopped_by"], "limit");
  EXPECT_EQ(answer.summary["passes"], answer.summary["steps"]);
  const auto &last = answer.summary["pass_table"].back();
  EXPECT_LE(last["eta_max"].get<double>(), .3);
  EXPECT_LE(last["increment"].get<double>(), .0015);
  const auto &before = answer.summary["pass_table"][answer.summary["passes"].get<std::size_t>() - 2];
  EXPECT_TRUE(before["eta_max"].get<double>() > .3 || before["increment"].get<double>() > .0015);
  EXPECT_EQ(answer.summary["counters"]["bodies"]["upper"]["factorisations"], 1);
  expect_balance(answer);
}

TEST(Combined, HasTheLimitOfTheDecompositionOnAFixedMesh)
{
  // Where no cell is split, its passes are the steps of the parallel Neumann scheme.
  const std::vector<std::string> bound = {"Decomposition/Stopping rule=bound", "Decomposition/Tolerance=1e-4",
                                          "Decomposition/Initial guess=elastic layer response"};
  const Answer steps = run_scene("two-layers", bound);
  std::vector<std::string> combined = combined_spr("1e3", 1000);
  combined.insert(combined.end(), bound.begin(), bound.end());
  const Answer passes = run_scene("two-layers", combined);
  ASSERT_EQ(steps.status, 0) << steps.err;
  ASSERT_EQ(passes.status, 0) << passes.err;
  EXPECT_NEAR(steps.summary["steps"].get<int>(), passes.summary["passes"].get<int>(), 1);
  const auto a = column(steps.directory + "/history.csv", "error_iteration");
  const auto b = column(passes.directory + "/history.csv", "error_iteration");
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); i += 20)
    EXPECT_NEAR(a[i], b[i], 1e-6 * a[i]) << "step " << i + 1;
}

TEST(Combined, NamesAGammaThatIsTooLarge)
{
  std::vector<std::string> combined = combined_spr("0.3", 20);
  combined.emplace_back("Decomposition/Relaxation=0.9");
  const Answer answer = run_scene("two-layers", combined);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.err.find("gamma = 0.9 is not below gamma* = 0.053"), std::string::npos) << answer.err;
}
