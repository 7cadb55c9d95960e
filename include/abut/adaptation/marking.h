// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/mesh/cell_marks.h>

namespace abut
{
  /**
   * Chooses the cells of one body that are split or may be merged, see `Marking`. `eta`: relative_errors of
   * `errors`. Cells whose error is zero are never split.
   */
  CellMarks mark(const CellErrors &errors, const Eigen::VectorXd &eta,
                 const AdaptationParameters &parameters);
} // namespace abut
