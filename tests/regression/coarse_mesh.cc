// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A cantilever that too few cells make too stiff, where no estimate is asked for.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <iostream>

using namespace abut::testing;

namespace
{
  const std::string cantilever = "set Bodies = beam\nsubsection Body beam\n set Size = 10, 1\n"
                                 " set Young modulus = 1e5\n set Cells = 80, 8\n"
                                 " set Conditions = left: displacement: 0, 0; right: traction: 0, -1\nend\n";

  double energy(const Answer &answer)
  {
    return answer.summary["bodies"][0]["energy"].get<double>();
  }
} // namespace

TEST(CoarseMesh, IsToldWhereTheErrorIsAboveAQuarter)
{
  const double exact = energy(run_text(cantilever, {"Discretisation/Degree=3"}));
  for (const std::string cells : {"10, 1", "20, 2", "40, 4", "80, 8", "20, 1"})
  {
    const Answer answer = run_text(cantilever, {"Body beam/Cells=" + cells});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double error = std::sqrt(1. - energy(answer) / exact); // energy norm, of the exact one
    std::cout << cells << " cells: energy error " << error << '\n';
    EXPECT_EQ(warning_codes(answer).count("coarse-mesh"), error > .25 ? 1u : 0u) << error;
  }
  EXPECT_EQ(warning_codes(run_text(cantilever, {"Body beam/Cells=5, 1", "Discretisation/Degree=2"}))
                .count("coarse-mesh"),
            0u);
}

TEST(CoarseMesh, IsLeftToAnEstimatorWhereThereIsOne)
{
  const Answer answer = run_text(cantilever, {"Body beam/Cells=10, 1", "Adaptation/Estimator=kelly"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(warning_codes(answer).count("coarse-mesh"), 0u);
}
