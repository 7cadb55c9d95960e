// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the whole error budget is worth: estimate and bound by the true error in the energy norm, at every
// pass of meshes that follow a tolerance.
#include "digits.h"
#include "solved_scene.h"
#include "tolerance_scenes.h"
#include <cctype>
#include <iomanip>
#include <iostream>
#include <tuple>

namespace
{
  using Case = std::tuple<std::size_t, unsigned int>; // scene, degree

  class BudgetStudy : public testing::TestWithParam<Case>
  {};

  std::vector<std::string> overrides(const ToleranceScene &scene, const unsigned int degree,
                                     const bool by_boundary_elements)
  {
    return scene.overrides + std::vector<std::string>{"Tolerance=1e-5",
                                                      "Discretisation/Degree=" + std::to_string(degree),
                                                      std::string("Adaptation/Estimator=") +
                                                          (by_boundary_elements ? "fe-be" : "automatic"),
                                                      "Adaptation/Marking=automatic",
                                                      "Adaptation/Maximum passes=8",
                                                      "Adaptation/Maximum unknowns=8000"};
  }

  TEST_P(BudgetStudy, is_near_the_true_error_at_every_pass)
  {
    const auto [number, degree] = GetParam();
    const ToleranceScene scene = tolerance_scenes()[number];
    const auto [least, most] = scene.estimate_limits(degree);
    const bool bounded = scene.is_straight || degree == 1;
    const SolvedScene solved(scene.file, overrides(scene, degree, bounded));
    std::cout << scene.name << ", degree " << degree << '\n'
              << "  unknowns  true error  estimate/true  bound/true  most of it\n";
    for (const abut::PassRecord &pass : solved.results().passes)
    {
      ASSERT_TRUE(pass.true_errors.energy && pass.budget.estimate());
      const double truth = *pass.true_errors.energy;
      const double estimate = *pass.budget.estimate() / truth;
      std::cout << std::setw(10) << pass.counts.dofs << std::setw(12) << std::setprecision(3) << truth
                << std::setw(15) << estimate;
      if (bounded)
        std::cout << std::setw(12) << *pass.budget.bound() / truth;
      std::cout << "  " << pass.budget.dominant().name << '\n';
      EXPECT_GE(estimate, least);
      EXPECT_LE(estimate, most);
      if (!bounded)
        continue;
      EXPECT_GE(*pass.budget.bound() / truth, .97);
      EXPECT_LE(*pass.budget.bound() / truth, degree == 1 ? 2. : 3.);
      EXPECT_EQ(pass.error_is_bound(), scene.is_proved) << pass.estimate_reason;
    }
    std::cout << std::flush;
  }

  std::string case_name(const testing::TestParamInfo<Case> &info)
  {
    std::string name = tolerance_scenes()[std::get<0>(info.param)].name;
    for (char &letter : name)
      letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    return name + "_degree_" + std::to_string(std::get<1>(info.param));
  }

  INSTANTIATE_TEST_SUITE_P(All, BudgetStudy,
                           testing::Combine(testing::Range(std::size_t(0), tolerance_scenes().size()),
                                            testing::Values(1u, 2u, 3u)),
                           case_name);
} // namespace
