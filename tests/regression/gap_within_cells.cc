// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Gaps that change within the cells that press: waves, steps.
#include <gtest/gtest.h>

#include "program.h"
#include <algorithm>
#include <cmath>
#include <iostream>

using namespace abut::testing;

namespace
{
  constexpr double wave_height = .003, wave_length = .1, wave_approach = .005, layer_modulus = 1000.,
                   layer_poisson = .3;

  /// A layer between planes of symmetry under a rigid wave, twenty times as long as that; `gap`: the wave is
  /// one of the gap's formula, the obstacle flat.
  std::string layer_under_wave(const bool gap)
  {
    const std::string top = gap ? "1" : "1.006",
                      outline = gap ? "f: (2,1)" : "f: y = 1.003 + 0.003*cos(20*pi*x) to (2,1.006)";
    return "set Bodies = layer, wave\nset Contacts = c\nsubsection Body layer\n set Size = 2, 1\n"
           " set Cells = 10, 5\n set Young modulus = 1000\n set Poisson ratio = 0.3\n"
           " set Conditions = bottom: normal displacement: 0; left: normal displacement: 0; "
           "right: normal displacement: 0\nend\n"
           "subsection Body wave\n set Shape = rigid outline\n set Outline = (2,2) -> (0,2) -> (0," +
           top + ") -> " + outline +
           " -> close\n set Conditions = f: displacement: 0, -0.005\nend\n"
           "subsection Contact c\n set Slave = layer:top\n set Master = wave:f\n" +
           (gap ? " set Gap = 0.003*(1 + cos(20*pi*x))\n" : "") + "end\n";
  }

  /// [Johnson1985, sec. 13.2]: a half-plane under a rigid wave touches along strips; the mean pressure p is
  /// p* sin^2 of their half-width, p* = pi E' height/length. By the compliance of collinear punches the mean
  /// gap is height (1 - q + q ln q), q = p/p*. The layer below gives way by p/M.
  double force_under_wave()
  {
    const double plane_modulus = layer_modulus / (1. - layer_poisson * layer_poisson),
                 stiffness = layer_modulus * (1. - layer_poisson) /
                             ((1. + layer_poisson) * (1. - 2. * layer_poisson)),
                 closing = M_PI * plane_modulus * wave_height / wave_length;
    double low = 0., high = closing;
    for (int i = 0; i < 60; ++i)
    {
      const double p = .5 * (low + high), q = p / closing;
      const double overlap = wave_approach - wave_height - p / stiffness; // of the mean planes
      (wave_height * (1. - q + q * std::log(q)) > -overlap ? low : high) = p;
    }
    return 2. * low;
  }

  double force_of_wave(const Answer &answer)
  {
    return contact_value(answer, "c", "normal_force");
  }
} // namespace

TEST(GapWithinCells, WavesAreToldUntilCellsFollowThem)
{
  for (const bool gap : {false, true})
    for (const std::string cells : {"5, 5", "10, 5", "14, 7", "320, 160"})
    {
      const Answer answer = run_text(layer_under_wave(gap), {"Body layer/Cells=" + cells});
      ASSERT_EQ(answer.status, 0) << answer.err;
      const double error = force_of_wave(answer) / force_under_wave() - 1.;
      std::cout << (gap ? "gap, " : "outline, ") << cells << " cells: force off by " << error << '\n';
      EXPECT_EQ(std::abs(error) > .1, cells != "320, 160");
      EXPECT_EQ(warning_codes(answer).count("coarse-gap"), cells == "320, 160" ? 0u : 1u) << answer.err;
    }
}

TEST(GapWithinCells, EveryEstimatorRefinesThere)
{
  for (const std::string estimator : {"kelly", "zz", "spr", "fe-be"})
  {
    const Answer answer = run_text(layer_under_wave(false),
                                   {"Body layer/Adapt=true", "Adaptation/Estimator=" + estimator,
                                    "Adaptation/Maximum passes=12", "Adaptation/Maximum unknowns=20000"});
    const double error = force_of_wave(answer) / force_under_wave() - 1.;
    std::cout << estimator << ": force off by " << error << '\n';
    EXPECT_LT(std::abs(error), .05) << estimator << '\n' << answer.err;
    const std::vector<double> totals = column(answer.directory + "/history.csv", "error_total");
    const auto first =
        std::find_if(totals.begin(), totals.end(), [](const double x) { return std::isfinite(x); });
    ASSERT_NE(first, totals.end());
    EXPECT_GT(*first, .3) << estimator;
  }
}

/// The gap is flat on both sides of a step: a punch with an edge.
TEST(GapWithinCells, AStepIsToldWhereItPresses)
{
  const std::string step = "0.01*(x < 0.63)";
  for (const std::string cells : {"10, 5", "37, 19"})
    EXPECT_EQ(warning_codes(
                  run_text(layer_under_wave(true), {"Contact c/Gap=" + step, "Body layer/Cells=" + cells}))
                  .count("singular-pressure"),
              1u)
        << cells;
  for (const std::string gap : {"if(x > 0.63, 0, 0.1*(0.63 - x))", "0", "0.01*(x < -1)"})
    EXPECT_EQ(
        warning_codes(run_text(layer_under_wave(true), {"Contact c/Gap=" + gap})).count("singular-pressure"),
        0u)
        << gap;
}
