// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/cell_marks.h>

#include <Eigen/Core>

#include <vector>

namespace abut
{
  /// What is known of a body's cells when cells are marked for a tolerance.
  struct GoalCells
  {
    Eigen::VectorXd squares; ///< squared errors, by active cell index
    unsigned int degree = 1;
    bool adapts = true; ///< else its error stays
  };

  /// Cells to be split, and what is expected of it.
  struct GoalMarks
  {
    std::vector<CellMarks> cells;     ///< body by body; none is merged
    std::vector<std::size_t> n_split; ///< of each body
    double expected = 1.;             ///< the error afterwards, by that before
  };

  /**
   * `Marking = automatic`: the fewest cells of all bodies together after whose splitting the error is
   * expected to be `aim` times the present one, but no more than carry most of it: farther, the next mesh
   * knows better. A cell that is split keeps 4^-p of its squared error, at least an eighth. Cells whose
   * errors are alike are treated alike.
   */
  GoalMarks goal_marks(const std::vector<GoalCells> &bodies, double aim);
} // namespace abut
