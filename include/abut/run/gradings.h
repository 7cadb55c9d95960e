// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/goal_marks.h>
#include <abut/base/executor.h>
#include <abut/results/results.h>

namespace abut
{
  /**
   * Where the stress is not smooth, splitting a cell gains little: of its squared error an eighth stays at an
   * end of contact, where the pressure is like a square root, about half at a vertex where the stress is
   * infinite and where contact is smaller than three parts. So cells there that are marked are split further,
   * towards the place, until what is expected to stay is what the other cells keep, or a tenth of the square
   * of the error that is aimed at: as many levels at once as meshes would have taken one by one.
   *
   * `cells`, `aim`: as goal_marks has them. Adds to the marks. All processes have to call it.
   */
  void grade_towards_singularities(const std::vector<GoalCells> &cells, double aim, const Solution &solution,
                                   const Executor &executor, std::vector<CellMarks> &marks);
} // namespace abut
