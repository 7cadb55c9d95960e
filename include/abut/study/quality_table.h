// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_run.h>

namespace abut
{
  /**
   * What the indicator of a variant is worth, a line for each pass whose exact response is known (see
   * EstimatorQuality), empty without any: the true stress error, effectivity and C of all cells, then of the
   * cells at the boundary, at the ends of contact and of the others; correlation of estimated and true cell
   * errors (Pearson) and of their ranks.
   */
  std::string quality_table(const StudyRun &run);

  /// The names of the same figures in study.csv.
  std::vector<std::string> quality_names();
  /// The figures of a pass; not a number where nothing is known.
  std::vector<double> quality_values(const PassRecord &pass);
} // namespace abut
