// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/mesh/cell_marks.h>
#include <abut/scene/marking_entry.h>

namespace abut
{
  /// Cells with eta below this, whose errors are round-off, are never split.
  constexpr double round_off_eta = 1e-9;

  /**
   * Chooses the cells of one body that are split or may be merged, by the scene's `Marking`. `eta`:
   * relative_errors of `errors`. Errors that symmetry makes equal are treated alike, also where a share would
   * end between them.
   */
  CellMarks mark(const CellErrors &errors, const Eigen::VectorXd &eta,
                 const AdaptationParameters &parameters);

  /// Cells by falling error; equal ones by index, so that the order is the same everywhere.
  std::vector<std::size_t> by_falling_error(const Eigen::VectorXd &errors);

  /// Splits the first `n_split` of the cells by falling error and lets those behind the first `n_kept` be
  /// merged; each number grows by the cells whose errors equal, within 1e-6, that of the last one counted.
  CellMarks split_first(const CellErrors &errors, const Eigen::VectorXd &eta, std::size_t n_split,
                        std::size_t n_kept);
} // namespace abut
