// SPDX-License-Identifier: LGPL-2.1-or-later
//
// `Tolerance` alone: the true error is below what was asked for, and not far below.
#include "digits.h"
#include "solved_scene.h"
#include "tolerance_scenes.h"
#include <array>
#include <cctype>
#include <iomanip>
#include <iostream>

namespace
{
  constexpr std::array<double, 8> tolerances = {{.1, .05, .02, .01, .005, .002, .0005, .0001}};

  class ToleranceStudy : public testing::TestWithParam<std::size_t>
  {
  protected:
    const ToleranceScene scene_ = tolerance_scenes()[GetParam()];

    std::vector<std::string> overrides(const double tolerance) const
    {
      return scene_.overrides +
             std::vector<std::string>{"Tolerance=" + digits_of(tolerance), "Adaptation/Estimator=automatic",
                                      "Adaptation/Marking=automatic", "Adaptation/Maximum passes=60",
                                      "Adaptation/Maximum unknowns=1000000"};
    }
    void expect_reached(const abut::Results &results, const double tolerance) const
    {
      const double truth = *results.true_errors.energy;
      EXPECT_EQ(results.adaptation_end->stopped_by, "tolerance") << results.message();
      EXPECT_LE(truth, tolerance);
      if (*results.passes.front().true_errors.energy > tolerance) // else the first mesh does
      {
        EXPECT_GE(truth, .2 * tolerance);
      }
      if (results.passes.back().pressure && results.true_errors.pressure)
      {
        EXPECT_LE(*results.passes.back().pressure, tolerance);
        EXPECT_LE(*results.true_errors.pressure, 1.4 * tolerance); // an estimate, no bound
      }
    }
    /// The penalty alone is above: the run says so, and how large it is.
    void expect_refused(const abut::Results &results, const double tolerance) const
    {
      EXPECT_FALSE(results.converged());
      EXPECT_EQ(results.adaptation_end->stopped_by, "penalty");
      EXPECT_GT(*results.true_errors.energy, tolerance);
      EXPECT_NEAR(*results.passes.back().budget.penalty / *results.true_errors.energy, 1., .1);
    }
  };

  TEST_P(ToleranceStudy, is_kept_and_not_overdone)
  {
    for (const double tolerance : tolerances)
    {
      SCOPED_TRACE(tolerance);
      const SolvedScene solved(scene_.file, overrides(tolerance));
      const abut::Results &results = solved.results();
      ASSERT_TRUE(results.true_errors.energy && results.adaptation_end);
      std::cout << std::left << std::setw(28) << scene_.name << std::right << std::setw(8) << tolerance
                << std::setw(12) << std::setprecision(3) << *results.true_errors.energy << std::setw(4)
                << results.passes.size() << " passes, pressure" << std::setw(12)
                << results.true_errors.pressure.value_or(0.) << std::setw(8)
                << results.passes.back().counts.dofs << " unknowns  " << results.adaptation_end->stopped_by
                << '\n'
                << std::flush;
      if (scene_.has_penalty && tolerance < .04)
        expect_refused(results, tolerance);
      else
        expect_reached(results, tolerance);
    }
  }

  std::string scene_name(const testing::TestParamInfo<std::size_t> &info)
  {
    std::string name = tolerance_scenes()[info.param].name;
    for (char &letter : name)
      letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    return name;
  }

  INSTANTIATE_TEST_SUITE_P(All, ToleranceStudy, testing::Range(std::size_t(0), tolerance_scenes().size()),
                           scene_name);
} // namespace
