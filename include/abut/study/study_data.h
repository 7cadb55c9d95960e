// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_run.h>

#include <string>
#include <variant>
#include <vector>

namespace abut
{
  /// Not a number where nothing is known.
  using StudyCell = std::variant<std::string, double>;

  /// What study.csv and study.html hold: a row for each pass of each variant.
  struct StudyData
  {
    std::vector<std::string> columns;
    std::vector<std::vector<StudyCell>> rows;
  };

  /**
   * Errors are relative. `true_error_*` is against what the column `reference` names; `budget_*` are the
   * parts of the estimated error (ErrorBudget). The last columns are those of each contact, of each swept
   * parameter and the codes of warnings.
   */
  StudyData study_data(const std::vector<StudyRun> &runs);

  /// For readers of the page: the same with what the study changes first, and nothing twice.
  StudyData shown_data(const std::vector<StudyRun> &runs);

  /// Texts in quotation marks, which are doubled within.
  std::string csv(const StudyData &data);
} // namespace abut
