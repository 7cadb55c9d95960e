// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The VTU files of a whole run: the turned patch test, two blocks under a uniform pressure along their own
// second axis.

#include <gtest/gtest.h>

#include "../unit/vtu_file.h"
#include "program.h"
#include <array>
#include <cmath>

using namespace abut::testing;
using abut::Vector2;

namespace
{
  constexpr double poisson_ratio = .3, young_modulus = 100., approach = 1e-3;
  constexpr double stiff = (1. - poisson_ratio * poisson_ratio) / young_modulus,
                   sideways = poisson_ratio * (1. + poisson_ratio) / young_modulus,
                   pressure = approach / (2. * stiff + .05 / young_modulus);

  struct PatchCase
  {
    std::string name;
    std::vector<std::string> overrides;
  };

  const std::vector<std::string> turned_by_30 = {
      "Body upper/Rotation angle=30", "Body lower/Rotation angle=30",
      "Body upper/Shift=-0.5, 0.86602540378443864676", "Adaptation/Maximum passes=1"};
  const Vector2 along(std::sqrt(.75), .5), across(-.5, std::sqrt(.75)); // the blocks' own axes

  /// In units of the pressure: xx, yy, xy of -across across^T, zz, von Mises.
  const std::vector<std::pair<std::string, double>> exact_stress = {
      {"stress_xx", -.25},
      {"stress_yy", -.75},
      {"stress_xy", .5 * std::sqrt(.75)},
      {"stress_zz", -poisson_ratio},
      {"von_mises", std::sqrt(1. - poisson_ratio + poisson_ratio * poisson_ratio)}};

  Vector2 exact_displacement(const std::string &body, const Vector2 &point)
  {
    const double x = point.dot(along), y = point.dot(across);
    const double down = body == "lower" ? -stiff * pressure * y : -approach + stiff * pressure * (2. - y);
    return sideways * pressure * x * along + down * across;
  }

  class VtuFields : public ::testing::TestWithParam<PatchCase>
  {};

  TEST_P(VtuFields, AreThoseOfTheExactSolution)
  {
    std::vector<std::string> overrides = GetParam().overrides;
    overrides.insert(overrides.end(), turned_by_30.begin(), turned_by_30.end());
    const Answer answer = run_scene("patch-test", overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string body : {"upper", "lower"})
    {
      SCOPED_TRACE(body);
      const VtuFile file(read_file(answer.directory + "/solution_" + body + ".vtu"));
      ASSERT_FALSE(file.points.empty());
      for (const char *const prefix : {"", "better_"})
        for (const auto &[name, expected] : exact_stress)
        {
          const auto field = file.fields.find(prefix + name);
          ASSERT_NE(field, file.fields.end()) << prefix << name;
          for (const double value : field->second.values) // single precision
            EXPECT_NEAR(value / pressure, expected, 1e-5) << prefix << name;
        }
      ASSERT_EQ(file.fields.count("displacement"), 1u);
      const VtuField &displacement = file.fields.at("displacement");
      for (std::size_t i = 0; i < file.points.size(); ++i)
      {
        const Vector2 expected = exact_displacement(body, file.points[i]);
        EXPECT_NEAR(displacement(i, 0), expected.x(), 1e-5 * approach);
        EXPECT_NEAR(displacement(i, 1), expected.y(), 1e-5 * approach);
      }
      for (const char *const name : {"mean_von_mises", "level", "eta"})
        ASSERT_EQ(file.fields.count(name), 1u) << name;
      for (const double mean : file.in_cells("mean_von_mises"))
        EXPECT_NEAR(mean / pressure, exact_stress.back().second, 1e-5);
      for (const double level : file.in_cells("level"))
        EXPECT_EQ(level, 0.);
      for (const double eta : file.in_cells("eta")) // of the stress; the estimators are exact here
        EXPECT_LT(eta, 1e-9);
    }
  }

  INSTANTIATE_TEST_SUITE_P(
      Patches, VtuFields,
      ::testing::Values(PatchCase{"quadrilaterals_zz", {"Adaptation/Estimator=zz"}},
                        PatchCase{"quadrilaterals_spr_degree_2",
                                  {"Adaptation/Estimator=spr", "Discretisation/Degree=2"}},
                        PatchCase{"triangles_spr",
                                  {"Adaptation/Estimator=spr", "Body upper/Cell type=triangles",
                                   "Body lower/Cell type=triangles"}},
                        PatchCase{"triangles_zz_degree_2",
                                  {"Adaptation/Estimator=zz", "Discretisation/Degree=2",
                                   "Body upper/Cell type=triangles", "Body lower/Cell type=triangles"}}),
      [](const auto &info) { return info.param.name; });
} // namespace
