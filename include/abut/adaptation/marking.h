// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>
#include <abut/mesh/cell_marks.h>

namespace abut
{
  /**
   * Chooses the cells of one body that are split or may be merged, see `Marking`. `eta`: relative_errors of
   * `errors`. Errors that symmetry makes equal are treated alike, also where a share would end between them.
   * Cells with eta below 1e-9, whose errors are round-off, are never split.
   */
  CellMarks mark(const CellErrors &errors, const Eigen::VectorXd &eta,
                 const AdaptationParameters &parameters);
} // namespace abut
