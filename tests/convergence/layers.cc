// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convergence_table.h"
#include "solved_scene.h"

namespace
{
  using Overrides = std::vector<std::string>;

  constexpr std::size_t stress = 0, pressure = 1, force = 2;

  const Overrides as_written;

  /// Of the cell size. The pressure ends like a root within one part: all of it there would be 1.2 h/a of the
  /// pressure's norm (a = 1.015), how much is wrong depends on where in the part the contact ends.
  constexpr double pressure_bound = .32;

  /// Of `prm/two-layers-rollers.prm`, with layers of unit height in cells of the width 4 / columns.
  Overrides matching_cells(const unsigned int columns, const double upper_height)
  {
    const unsigned int rows = columns / 4;
    const auto upper_rows = static_cast<unsigned int>(std::lround(rows * upper_height));
    const std::string n = std::to_string(columns) + ", ";
    return {"Body upper/Cells=" + n + std::to_string(upper_rows),
            "Body lower/Cells=" + n + std::to_string(rows)};
  }

  ConvergenceTable study(const std::string &title, const Overrides &changes,
                         const std::vector<unsigned int> &columns, const double upper_height = 1.)
  {
    ConvergenceTable table("Two layers between rollers, relative errors in L2 (stress: xx, yy, zz, 2 xy). " +
                               title,
                           {"stress", "pressure", "force"});
    for (const unsigned int n : columns)
    {
      Overrides overrides = matching_cells(n, upper_height);
      overrides.insert(overrides.end(), changes.begin(), changes.end());
      const SolvedScene scene("two-layers-rollers.prm", overrides);
      const abut::TrueErrors &errors = scene.results().true_errors;
      table.add(4. / n, {errors.stress.value(), errors.pressure.value(), errors.force.value()});
    }
    table.print();
    return table;
  }

  TEST(Layers, matching_meshes_against_the_series)
  {
    const ConvergenceTable table = study("As written", as_written, {32, 64, 128});
    for (std::size_t row = 0; row < 3; ++row)
      EXPECT_LE(table.error(row, pressure), pressure_bound * 4. / (32. * (1 << row)));
    for (const std::size_t row : {1u, 2u})
      EXPECT_NEAR(table.rate(row, stress), 1., .1);
  }

  // With c = 0.05 the penalty alone takes 2.9 % off the force: what is left against the solution that has it
  // too are the meshes, as without it.
  TEST(Layers, matching_meshes_against_the_solution_with_the_penalty)
  {
    const ConvergenceTable table =
        study("Penalty c = 0.05 in both",
              {"Contact interface/Penalty coefficient=0.05", "Reference/Contact=penalised"}, {32, 64, 128});
    for (std::size_t row = 0; row < 3; ++row)
      EXPECT_LE(table.error(row, pressure), pressure_bound * 4. / (32. * (1 << row)));
    for (const std::size_t row : {1u, 2u})
      EXPECT_NEAR(table.rate(row, stress), 1., .1);
    EXPECT_LE(table.error(2, force), 5e-4);
  }

  TEST(Layers, triangles_upon_quadrilaterals)
  {
    const ConvergenceTable table =
        study("Upper layer in triangles", {"Body upper/Cell type=triangles"}, {64, 128});
    EXPECT_NEAR(table.rate(1, stress), 1., .1);
    EXPECT_LE(table.error(1, pressure), pressure_bound * 4. / 128.);
    EXPECT_LE(table.error(1, force), 1e-3);
  }

  TEST(Layers, nonmatching_meshes_against_the_series)
  {
    const SolvedScene scene("two-layers-rollers.prm", as_written); // 96 x 24 upon 128 x 32
    const double exact_force = 133.8364523567, exact_peak = 172.0703323845;
    const abut::PairResult &pair = scene.pair();
    const double peak = pair.max_pressure, pressure_error = scene.results().true_errors.pressure.value();
    std::cout << "Two layers between rollers, nonmatching meshes: relative errors of the force "
              << pair.normal_force / exact_force - 1. << ", of the peak " << peak / exact_peak - 1.
              << ", of the pressure in L2 " << pressure_error << '\n';
    EXPECT_NEAR(pair.normal_force, exact_force, 5e-4 * exact_force);
    EXPECT_NEAR(peak, exact_peak, 2.5e-3 * exact_peak);
    EXPECT_LE(pressure_error, .01);
  }

  /**
   * Other data, same mesh sizes. A first-order error of the stress is C h / l, l the length over which the
   * stress varies: the smaller of the half-width of the contact (1.17 to 1.45 here, 1.02 as written) and the
   * height of the layers (1 to 1.5; 1). So the error must not exceed that of the scene as written, 2.4 % for
   * 64 columns, by more than C does: a quarter is left to it, for nu = 0.4.
   */
  void expect_errors_as_before(const ConvergenceTable &table)
  {
    EXPECT_LE(table.error(0, stress), 1.25 * .024);
    EXPECT_LE(table.error(1, stress), 1.25 * .012);
    EXPECT_NEAR(table.rate(1, stress), 1., .1);
    EXPECT_LE(table.error(0, pressure), .02);
    EXPECT_LE(table.error(1, pressure), pressure_bound * 4. / 128.);
    EXPECT_LE(table.error(1, force), 5e-4);
  }

  TEST(Layers, pressed_further)
  {
    expect_errors_as_before(study("Approach 2.5e-3", {"Constants/Values=1e-3, 2.5e-3"}, {64, 128}));
  }

  TEST(Layers, other_material_and_gap)
  {
    expect_errors_as_before(
        study("E = 7e4, nu = 0.2, r0 = 4e-4, approach 1e-3",
              {"Constants/Values=4e-4, 1e-3", "Body upper/Young modulus=7e4", "Body upper/Poisson ratio=0.2",
               "Body lower/Young modulus=7e4", "Body lower/Poisson ratio=0.2"},
              {64, 128}));
  }

  TEST(Layers, different_bodies)
  {
    expect_errors_as_before(study("Upper: E = 7e4, nu = 0.4, height 1.5; approach 1.8e-3",
                                  {"Constants/Values=1e-3, 1.8e-3", "Body upper/Young modulus=7e4",
                                   "Body upper/Poisson ratio=0.4", "Body upper/Size=4, 1.5"},
                                  {64, 128}, 1.5));
  }
} // namespace
