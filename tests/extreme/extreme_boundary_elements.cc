// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the estimator fe-be is worth at the limits, against the exact response: |effectivity - 1| <= C < .15.
#include <gtest/gtest.h>

#include "../regression/program.h"

using namespace abut::testing;

namespace
{
  /// Effectivity and C of the last pass on the layers between rollers.
  nlohmann::json quality(std::vector<std::string> overrides)
  {
    for (const std::string common :
         {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4", "Adaptation/Estimator=fe-be",
          "Adaptation/Maximum passes=1", "Decomposition/Scheme=newton",
          "Contact interface/Penalty coefficient=5e-2"})
      overrides.insert(overrides.begin(), common);
    const Answer answer = run_scene("two-layers-rollers", overrides);
    EXPECT_EQ(answer.status, 0) << answer.err;
    return answer.summary["pass_table"].back()["estimator"]["whole"];
  }

  void expect_worth(const std::vector<std::string> &overrides)
  {
    SCOPED_TRACE(overrides.back());
    const nlohmann::json whole = quality(overrides);
    EXPECT_LT(whole["better_ratio"].get<double>(), .15);
    EXPECT_NEAR(whole["effectivity"].get<double>(), 1., .05);
  }
} // namespace

TEST(ExtremeBoundaryElements, ModuliOneToOneHundredMillion)
{
  for (const std::string modulus : {"2.1e13", "2.1e-3"})
    expect_worth({"Body upper/Young modulus=" + modulus});
}

TEST(ExtremeBoundaryElements, NearlyIncompressible)
{
  for (const std::string nu : {"0.4999", "0.4999999"})
    expect_worth({"Body upper/Poisson ratio=" + nu, "Body lower/Poisson ratio=" + nu});
}

TEST(ExtremeBoundaryElements, LengthsTimesAMillionEitherWay)
{
  // With exact quadrature all is the same but for round-off. The quick rule changes the number of points at
  // certain distances, where round-off decides: sigma_B by some 1e-4 of what it differs from sigma*.
  for (const auto &[kind, tolerance] : {std::pair("reference quality", 1e-9), std::pair("trace space", 1e-3)})
  {
    const std::string solution = std::string("Adaptation/Boundary solution=") + kind;
    const nlohmann::json plain = quality({solution});
    for (const std::string scale : {"1e-6", "1e6"})
    {
      const nlohmann::json scaled = quality({solution, "Body upper/Scale=" + scale,
                                             "Body lower/Scale=" + scale, "Body upper/Shift=0, " + scale});
      for (const std::string key : {"effectivity", "better_ratio", "computed_error"})
        EXPECT_NEAR(scaled[key].get<double>() / plain[key].get<double>(), 1., tolerance)
            << kind << ' ' << scale << ' ' << key;
    }
  }
}

TEST(ExtremeBoundaryElements, FlatCells)
{
  // A hundred to one: edges across the body a hundred times shorter than those along it.
  expect_worth({"Body upper/Cells=12, 4", "Body lower/Cells=12, 300"});
}
