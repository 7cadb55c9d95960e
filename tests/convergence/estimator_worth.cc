// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the estimators without a bound are worth at a degree: error.total by the true error in the energy
// norm, over all passes of scenes with exact solutions. The ranges that warnings and reports name must hold
// them.
#include <abut/scene/estimator_entry.h>

#include "solved_scene.h"
#include <iomanip>
#include <iostream>

namespace
{
  struct Worth
  {
    std::string name;
    unsigned int degree;
  };

  std::ostream &operator<<(std::ostream &out, const Worth &worth)
  {
    return out << worth.name << worth.degree;
  }

  struct WorthScene
  {
    std::string file;
    std::vector<std::string> overrides;
  };

  const std::vector<std::string> layers = {"Body upper/Cells=16, 4", "Body lower/Cells=16, 4",
                                           "Body upper/Adapt=true", "Body lower/Adapt=true"};

  std::vector<WorthScene> worth_scenes()
  {
    WorthScene uniform{"two-layers-rollers.prm", layers};
    uniform.overrides.insert(
        uniform.overrides.end(),
        {"Adaptation/Marking=fixed fraction", "Adaptation/Fraction=1", "Adaptation/Maximum passes=3"});
    return {{"two-layers-rollers.prm", layers},
            uniform,
            {"two-layers-rollers-bonded.prm", layers},
            {"flat-punch.prm", {}},
            {"corner.prm", {}}};
  }

  class EstimatorWorth : public testing::TestWithParam<Worth>
  {};

  TEST_P(EstimatorWorth, is_within_the_range_that_is_told)
  {
    const auto [name, degree] = GetParam();
    double least = std::numeric_limits<double>::infinity(), most = 0.;
    for (const WorthScene &scene : worth_scenes())
    {
      std::vector<std::string> overrides = {"Discretisation/Degree=" + std::to_string(degree),
                                            "Adaptation/Estimator=" + name, "Adaptation/Maximum passes=7"};
      overrides.insert(overrides.end(), scene.overrides.begin(), scene.overrides.end());
      const SolvedScene solved(scene.file, overrides);
      for (const abut::PassRecord &pass : solved.results().passes)
      {
        EXPECT_FALSE(pass.error_is_bound());
        least = std::min(least, pass.effectivity_total.value());
        most = std::max(most, pass.effectivity_total.value());
      }
    }
    std::cout << std::setw(6) << name << " degree " << degree << std::fixed << std::setprecision(2)
              << "  estimated by true error " << least << " to " << most << '\n'
              << std::defaultfloat << std::setprecision(6);
    const abut::EstimatorWorth told =
        *abut::Registry<abut::EstimatorEntry>::get().find(name).worth_at(degree);
    EXPECT_GE(least, told.least);
    EXPECT_LE(most, told.most);
    // ... and is not much wider than it has to be.
    constexpr double slack = .2;
    EXPECT_LE(least, told.least + slack);
    EXPECT_GE(most, told.most - slack);
  }

  std::vector<Worth> all_worths()
  {
    std::vector<Worth> all;
    for (const unsigned int degree : {1u, 2u, 3u})
      for (const std::string name : {"kelly", "zz", "spr"})
        all.push_back({name, degree});
    return all;
  }

  INSTANTIATE_TEST_SUITE_P(Exact, EstimatorWorth, testing::ValuesIn(all_worths()),
                           testing::PrintToStringParamName());
} // namespace
