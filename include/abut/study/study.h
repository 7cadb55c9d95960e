// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/checks/validity.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace abut
{
  /// What a study says beside its numbers, sentences without the full stop.
  struct StudyMessages
  {
    Warnings warnings; ///< of the variants (study_warnings), not of fine runs
    /// On variants without results, on those that did not reach what they were asked for and on fine runs
    /// that are no reference.
    std::vector<std::string> complaints;
  };

  /**
   * Runs the variants that the section `Study` of a file lists, one after the other, prints error against
   * unknowns and against seconds for every pass of each and, where the exact response is known, what the
   * estimator is worth, then force, pressure, stress and energy of each; writes the same to study.csv and
   * study.html in the output directory. Throws UserError, also for a file without variants, and
   * ComputationError where no variant has results.
   */
  StudyMessages run_study(const std::string &file, const std::vector<std::string> &overrides, bool quiet,
                          std::ostream &out);

  /// Checks every variant as `abut --check` does, prints a line for each and returns the warnings of the
  /// input. Throws UserError, which names the variant, at the first that is refused.
  Warnings check_study(const std::string &file, const std::vector<std::string> &overrides, std::ostream &out);
} // namespace abut
