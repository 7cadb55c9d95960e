// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /// One variant of a study.
  struct StudyRun
  {
    std::string name;
    std::vector<PassRecord> passes;
  };

  /// Error against unknowns and seconds, a line for each pass. `order` is that of the stress error, or of the
  /// estimated one where no exact solution is named: minus the slope against the unknowns in double
  /// logarithmic scale, from the pass before; `x sqrt` is that error times the square root of the unknowns.
  std::string study_table(const StudyRun &run);

  /// A row for each pass of each variant; errors are relative, cells empty where nothing is known.
  std::string study_csv(const std::vector<StudyRun> &runs);
} // namespace abut
