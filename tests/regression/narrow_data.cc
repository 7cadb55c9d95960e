// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Loads and displacements that the first mesh is too coarse for.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>

using namespace abut::testing;

namespace
{
  std::string narrow_block(const std::string &top, const std::string &force)
  {
    return "set Bodies = block\nsubsection Body block\n set Size = 4, 1\n set Young modulus = 2e5\n"
           " set Poisson ratio = 0.3\n set Conditions = bottom: displacement: 0, 0; top: " +
           top + "\n set Body force = " + force + "\nend\n";
  }

  const std::string narrow_patch = narrow_block("traction: 0, -100*(abs(x-1.31)<0.002)", ""),
                    narrow_waves = narrow_block("displacement: 0, 1e-3*(1+sin(8*pi*x))",
                                                ""), // zero at the nodes of 8 x 2 cells
      narrow_force = narrow_block("traction: 0, -0.001", "0, -1000*exp(-2500*((x-1.31)^2+(y-0.37)^2))");

  double block_energy(const Answer &answer)
  {
    return answer.summary["bodies"][0]["energy"].get<double>();
  }

  /// By another degree, another start and another estimator, to some 1e-4.
  double fine_energy(const std::string &scene)
  {
    const Answer answer = run_text(scene, {"Discretisation/Degree=2", "Body block/Cells=100, 25",
                                           "Body block/Adapt=true", "Adaptation/Estimator=kelly",
                                           "Adaptation/Marking=doerfler", "Adaptation/Maximum passes=13"});
    EXPECT_NE(answer.status, 1) << answer.err;
    return block_energy(answer);
  }
} // namespace

// Loads alone, or displacements alone, drive these bodies: the square of the error is the difference in
// energy. Estimates may be a fifth too small.
TEST(NarrowData, AreWithinATolerance)
{
  for (const std::string &scene : {narrow_patch, narrow_waves, narrow_force})
  {
    const double exact = fine_energy(scene);
    for (const double tolerance : {.1, .01})
    {
      SCOPED_TRACE(scene + std::to_string(tolerance));
      const Answer answer = run_text(scene, {"Tolerance=" + std::to_string(tolerance)});
      ASSERT_EQ(answer.status, 0) << answer.err;
      EXPECT_LT(std::sqrt(std::abs(block_energy(answer) / exact - 1.)), tolerance / .8);
      EXPECT_EQ(warning_codes(answer).count("coarse-data"), 0u) << answer.err;
    }
  }
}

TEST(NarrowData, AreCountedByEveryEstimator)
{
  const double exact = fine_energy(narrow_waves);
  for (const std::string estimator : {"kelly", "zz", "spr", "fe-be"})
  {
    const Answer answer =
        run_text(narrow_waves, {"Adaptation/Estimator=" + estimator, "Body block/Cells=8, 2"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double error = std::sqrt(std::abs(block_energy(answer) / exact - 1.));
    EXPECT_GT(error, .9) << estimator; // all of the waves is missed
    EXPECT_GT(answer.summary["error"]["estimate"].get<double>(), .5 * error) << estimator;
    EXPECT_EQ(warning_codes(answer).count("coarse-data"), 1u) << answer.err;
  }
}
