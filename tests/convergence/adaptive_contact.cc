// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact scenes against the exact stress that they name: orders on uniform meshes, effectivity, and the
// exact stress itself against fine computations.

#include "adaptive_passes.h"
#include "convergence_table.h"

namespace
{
  using abut::TrueErrors;
  using Overrides = std::vector<std::string>;

  /// True errors of stress and pressure of a scene with `n` cells to a unit, whatever that is.
  template <typename Cells>
  ConvergenceTable uniform_study(const std::string &title, const std::string &scene, const Overrides &changes,
                                 const std::vector<unsigned int> &sizes, const Cells &cells)
  {
    ConvergenceTable table(title + ", relative errors", {"energy norm", "stress", "pressure"});
    for (const unsigned int n : sizes)
    {
      Overrides overrides = cells(n);
      overrides.insert(overrides.end(), changes.begin(), changes.end());
      const SolvedScene solved(scene, overrides);
      const TrueErrors &errors = solved.results().true_errors;
      table.add(1. / n, {errors.energy.value(), errors.stress.value(), errors.pressure.value()});
    }
    table.print();
    return table;
  }

  std::string pair_of(const unsigned int first, const unsigned int second)
  {
    return std::to_string(first) + ", " + std::to_string(second);
  }

  Overrides fit_cells(const unsigned int n)
  {
    return {"Body disc/Cells=" + pair_of(2 * n, n), "Body ring/Cells=" + pair_of(3 * n, 2 * n)};
  }

  Overrides layer_cells(const unsigned int n)
  {
    return {"Body upper/Cells=" + pair_of(4 * n, n), "Body lower/Cells=" + pair_of(4 * n, n)};
  }

  /// Penalties so small that theta/(k + theta), what they take off the pressure, is far below the errors.
  const std::string fit_penalty = "Contact fit/Penalty coefficient=2e-5"; // a share of 1e-5
  const std::string many_steps = "Decomposition/Maximum steps=2000000";

  /// Everything is smooth: order p.
  TEST(ExactStress, shrink_fit_on_uniform_meshes)
  {
    for (const unsigned int degree : {1u, 2u})
    {
      const ConvergenceTable table =
          uniform_study("Shrink fit against Lame, degree " + std::to_string(degree), "shrink-fit.prm",
                        {"Discretisation/Degree=" + std::to_string(degree), fit_penalty, many_steps,
                         "Decomposition/Tolerance=1e-7"},
                        {4, 8, 16}, fit_cells);
      EXPECT_NEAR(table.last_rate(0), degree, .1);
      EXPECT_NEAR(table.last_rate(1), degree, .1);
    }
  }

  /**
   * At the edge of the contact the stress is like the root of the distance: orders 1, then 3/2 instead of 2,
   * where the error hangs upon the edge's place within its cell: by a factor of 1.5, if it must, over three
   * halvings.
   */
  TEST(ExactStress, bonded_layers_on_uniform_meshes)
  {
    const double orders[] = {1., 1.5}, tolerances[] = {.1, std::log2(1.5) / 3.};
    for (const unsigned int degree : {1u, 2u})
    {
      const ConvergenceTable table = uniform_study(
          "Bonded layers between rollers, degree " + std::to_string(degree), "two-layers-rollers-bonded.prm",
          {"Discretisation/Degree=" + std::to_string(degree), "Contact interface/Penalty coefficient=2e-4",
           many_steps},
          {4, 8, 16, 32}, layer_cells);
      EXPECT_NEAR(table.overall_rate(0), orders[degree - 1], tolerances[degree - 1]);
      EXPECT_NEAR(table.overall_rate(1), orders[degree - 1], tolerances[degree - 1]);
    }
  }

  /// The estimate against the response to the pressure that was applied: asymptotically exact for spr.
  TEST(ExactStress, effectivity_of_spr_for_different_sliding_layers)
  {
    const AdaptivePasses passes(
        "Sliding layers, the upper one with E = 7e4, nu = 0.4, height 1.5", "two-layers-rollers.prm",
        {"Constants/Values=1e-3, 1.8e-3", "Body upper/Young modulus=7e4", "Body upper/Poisson ratio=0.4",
         "Body upper/Size=4, 1.5", "Body upper/Cells=64, 24", "Body lower/Cells=80, 20",
         "Contact interface/Penalty coefficient=5e-3", "Adaptation/Estimator=spr"});
    EXPECT_NEAR(passes.last_effectivity(), 1., .05);
  }

  /**
   * The series against polynomials of degree 3 on meshes that follow the error: two ways to the same stress
   * that have nothing in common. The penalty's share is below 1e-4.
   */
  class ExactLayers : public ::testing::TestWithParam<std::string>
  {};

  TEST_P(ExactLayers, AgreeWithAFineComputation)
  {
    const AdaptivePasses passes(GetParam() + ", degree 3, adapted", GetParam() + ".prm",
                                {"Discretisation/Degree=3", "Body upper/Cells=8, 2", "Body lower/Cells=8, 2",
                                 "Body upper/Adapt=true", "Body lower/Adapt=true", "Adaptation/Estimator=spr",
                                 "Adaptation/Maximum passes=30", "Adaptation/Maximum unknowns=15000",
                                 "Contact interface/Penalty coefficient=1e-4", many_steps});
    EXPECT_LT(passes.last_stress_error(), 2e-4);
    EXPECT_LT(passes.last_energy_error(), 2e-4);
  }

  INSTANTIATE_TEST_SUITE_P(Layers, ExactLayers,
                           ::testing::Values("two-layers-rollers", "two-layers-rollers-bonded"),
                           [](const auto &parameter) {
                             return parameter.index == 0 ? std::string("Sliding") : std::string("Bonded");
                           });
} // namespace
