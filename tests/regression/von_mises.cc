// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One von Mises stress: that of the table is that of the files.

#include <gtest/gtest.h>

#include "../unit/vtu_file.h"
#include "program.h"
#include <algorithm>
#include <cmath>

using namespace abut::testing;

namespace
{
  /// A field of a VTU file, at its points.
  std::vector<double> vtu_array(const std::string &path, const std::string &name)
  {
    const VtuFile file(read_file(path));
    return file.fields.at(name).values;
  }

  double largest(const std::vector<double> &values)
  {
    return *std::max_element(values.begin(), values.end());
  }
} // namespace

TEST(VonMises, IsTheSameInTableAndFile)
{
  for (const auto &[scene, overrides] :
       {std::pair<std::string, std::vector<std::string>>{"hertz", {}},
        {"three-bodies", {"Discretisation/Degree=2"}},
        {"two-layers", {"Discretisation/Degree=3"}},
        {"two-layers", {"Body upper/Cell type=triangles", "Body upper/Degree=2"}}})
  {
    const Answer answer = run_scene(scene, overrides);
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const auto &body : answer.summary["bodies"])
    {
      const std::string file = answer.directory + "/solution_" + body["name"].get<std::string>() + ".vtu";
      const double in_table = body["max_von_mises"];
      EXPECT_NEAR(largest(vtu_array(file, "von_mises")), in_table, 1e-6 * in_table) << scene << body["name"];
      EXPECT_LT(largest(vtu_array(file, "mean_von_mises")), in_table);
    }
  }
}

TEST(VonMises, TheBetterOneIsThatOfItsComponents)
{
  for (const std::string estimator : {"spr", "zz", "fe-be"})
  {
    const Answer answer = run_scene(
        "two-layers", {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4", "Discretisation/Degree=2",
                       "Adaptation/Estimator=" + estimator, "Adaptation/Maximum passes=1"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string body : {"upper", "lower"})
    {
      const std::string file = answer.directory + "/solution_" + body + ".vtu";
      const auto xx = vtu_array(file, "better_stress_xx"), yy = vtu_array(file, "better_stress_yy"),
                 xy = vtu_array(file, "better_stress_xy"), zz = vtu_array(file, "better_stress_zz"),
                 von_mises = vtu_array(file, "better_von_mises");
      ASSERT_FALSE(von_mises.empty());
      const double peak = largest(von_mises);
      for (std::size_t i = 0; i < von_mises.size(); ++i)
      {
        const double of_components = std::sqrt(
            .5 * (std::pow(xx[i] - yy[i], 2) + std::pow(yy[i] - zz[i], 2) + std::pow(zz[i] - xx[i], 2)) +
            3. * xy[i] * xy[i]);
        EXPECT_NEAR(von_mises[i], of_components, 1e-5 * peak);
      }
    }
  }
}
