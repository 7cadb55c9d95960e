// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the error bound of the estimator fe-be is worth: error.total by the true error in the energy norm, of
// two layers between rollers against the series. Mesh ratios of 1:16 to 16:1, moduli of 1e-3 to 1e3, exact
// contact and penalties (then against the penalised solution), uniform and adapted meshes.
#include "digits.h"
#include "roller_layers.h"
#include "solved_scene.h"
#include <iomanip>
#include <iostream>

namespace
{
  struct BoundCase
  {
    unsigned int upper_columns, lower_columns;
    double stiffness; ///< E of the upper layer by that of the lower one
    double penalty = 0., poisson_ratio = roller_layers::poisson_ratio;
    bool is_estimate = false; ///< within the same limits, but theory does not say so
    std::vector<std::string> adapted = {};
  };

  std::vector<std::string> overrides(const unsigned int degree, const BoundCase &c)
  {
    const auto cells = [](const unsigned int columns) {
      return std::to_string(columns) + ", " + std::to_string(columns / 4);
    };
    std::vector<std::string> list = {
        "Discretisation/Degree=" + std::to_string(degree),
        "Body upper/Cells=" + cells(c.upper_columns),
        "Body lower/Cells=" + cells(c.lower_columns),
        "Body upper/Young modulus=" + digits_of(roller_layers::modulus * c.stiffness),
        "Body upper/Poisson ratio=" + digits_of(c.poisson_ratio),
        "Body lower/Poisson ratio=" + digits_of(c.poisson_ratio),
        "Contact interface/Penalty coefficient=" + digits_of(c.penalty),
        "Decomposition/Tolerance=1e-7",
        "Adaptation/Estimator=fe-be",
        "Adaptation/Maximum passes=" + std::to_string(c.adapted.empty() ? 1 : 6)};
    if (c.penalty > 0.)
      list.emplace_back("Reference/Contact=penalised");
    for (const std::string &body : c.adapted)
      list.push_back("Body " + body + "/Adapt=true");
    return list;
  }

  class BoundStudy : public testing::TestWithParam<unsigned int>
  {
  protected:
    /// Prints a row, expects every pass to bound its error and to be below `largest` times it.
    void expect_bound(const BoundCase &c, const double largest) const
    {
      const SolvedScene scene("two-layers-rollers.prm", overrides(GetParam(), c));
      std::cout << "degree " << GetParam() << std::setw(5) << c.upper_columns << ':' << std::left
                << std::setw(4) << c.lower_columns << std::right << "  E1/E2 " << std::setw(6) << c.stiffness
                << "  nu " << std::setw(9) << std::setprecision(8) << c.poisson_ratio << "  c "
                << std::setw(6) << c.penalty << "  bound/error";
      for (const abut::PassRecord &pass : scene.results().passes)
      {
        ASSERT_TRUE(pass.effectivity_total.has_value());
        EXPECT_EQ(pass.error_is_bound(), !c.is_estimate) << pass.estimate_reason;
        EXPECT_GE(*pass.effectivity_total, .97);
        EXPECT_LE(*pass.effectivity_total, largest);
        std::cout << ' ' << std::fixed << std::setprecision(3) << *pass.effectivity_total;
      }
      std::cout << std::defaultfloat << std::setprecision(6);
      for (const std::string &body : c.adapted)
        std::cout << ' ' << body;
      std::cout << '\n' << std::flush;
    }
    double largest() const { return GetParam() == 1 ? 2. : 3.; }
  };

  TEST_P(BoundStudy, holds_for_all_ratios_of_cells_and_moduli)
  {
    for (const auto &[upper, lower] : {std::pair(4u, 64u), std::pair(16u, 64u), std::pair(24u, 32u),
                                       std::pair(32u, 32u), std::pair(64u, 16u), std::pair(64u, 4u)})
      for (const double stiffness : {1e-3, 1., 1e3})
        expect_bound({upper, lower, stiffness}, largest());
  }

  TEST_P(BoundStudy, holds_after_two_more_halvings)
  {
    for (const auto &[upper, lower] : {std::pair(64u, 64u), std::pair(128u, 128u)})
      expect_bound({upper, lower, 1.}, largest());
  }

  TEST_P(BoundStudy, holds_with_penalties)
  {
    for (const double penalty : {5e-4, .05})
      for (const auto &[upper, lower] : {std::pair(8u, 64u), std::pair(32u, 32u), std::pair(64u, 8u)})
        expect_bound({upper, lower, 1., penalty}, largest());
  }

  TEST_P(BoundStudy, holds_on_adapted_meshes_where_one_body_adapts_or_both)
  {
    using Bodies = std::vector<std::string>;
    for (const Bodies &bodies : {Bodies{"upper"}, Bodies{"lower"}, Bodies{"upper", "lower"}})
      for (const double stiffness : {1e-2, 1., 1e2})
        expect_bound({8, 16, stiffness, 0., roller_layers::poisson_ratio, false, bodies}, largest());
  }

  TEST_P(BoundStudy, is_an_estimate_as_good_for_nearly_incompressible_layers)
  {
    for (const double poisson_ratio : {.41, .49, .4999, .4999999})
      for (const auto &[upper, lower] : {std::pair(16u, 64u), std::pair(24u, 32u), std::pair(32u, 32u)})
        expect_bound({upper, lower, 1., 0., poisson_ratio, true}, largest());
  }

  INSTANTIATE_TEST_SUITE_P(Degree, BoundStudy, testing::Values(1u, 2u, 3u));
} // namespace
