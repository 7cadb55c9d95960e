// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/penalty_sensitivity.h>
#include <abut/mesh/cell_marks.h>
#include <abut/results/goal_record.h>
#include <abut/results/results.h>
#include <abut/run/setup.h>

namespace abut
{
  /// Throws UserError where no body has the point of a stress, or there is no contact. All processes have to
  /// call it, as what follows.
  void check_goal(const Scene &scene, const Model &model);

  /// The goal's value and error in a pass. `penalty`: what it changes, empty where that is not known.
  GoalRecord goal_record(const Setup &setup, const Solution &solution,
                         const std::optional<PenaltyChange> &penalty, const std::vector<PassRecord> &before);

  /// Marks the cells in which the goal's value stands, in bodies that adapt: the energy norm may leave them
  /// coarse.
  void mark_goal(const Scene &scene, const Solution &solution, const Executor &executor,
                 std::vector<CellMarks> &marks);
} // namespace abut
