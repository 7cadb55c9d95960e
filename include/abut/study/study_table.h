// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_run.h>

namespace abut
{
  /// Error against unknowns and seconds, a line for each pass; columns without any number are left out.
  /// `order` is that of the stress error, or of the estimated one where no exact solution is named: minus the
  /// slope against the unknowns in double logarithmic scale, from the pass before; `x sqrt(unknowns)` is that
  /// error times the square root of the unknowns.
  std::string study_table(const StudyRun &run);

  /// What the columns of these tables mean; empty where none has errors.
  std::string study_table_legend(const std::vector<StudyRun> &runs);
} // namespace abut
