// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/cell_marks.h>
#include <abut/results/results.h>

#include <optional>
#include <vector>

namespace abut
{
  /// Of all contacts, relative in L2, by PressureError; nothing where nothing presses, or where that is not
  /// estimated.
  std::optional<double> relative_pressure_error(const std::vector<PairResult> &pairs);

  /// Whether a `Tolerance` is met by that error: it asks nothing of pressures where the run has a goal of its
  /// own, or where their error is not known.
  bool pressures_meet_tolerance(const Scene &scene, const std::optional<double> &error);

  /**
   * Adds to the marks of bodies that adapt the cells on both sides where most of the error of the pressures
   * is, as far as it is above `tolerance`; cells at the ends of contact are graded, a level halves the error
   * there.
   */
  void mark_pressures(const Scene &scene, const Solution &solution, double tolerance,
                      std::vector<CellMarks> &marks);
} // namespace abut
