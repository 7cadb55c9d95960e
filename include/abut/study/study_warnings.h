// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_run.h>

#include <string>
#include <vector>

namespace abut
{
  /// What one variant warns of.
  struct VariantWarnings
  {
    std::string variant; ///< its name
    Warnings warnings;
  };

  /**
   * What the variants of a study warn of, each once: the text of the first variant that has it, behind it in
   * parentheses which ones have it, and whose numbers these are where others have other ones. Warnings of
   * different variants are the same where code and text are, apart from numbers in the text.
   */
  Warnings study_warnings(const std::vector<VariantWarnings> &variants);
  Warnings study_warnings(const std::vector<StudyRun> &runs);

  /// Their codes, each once, separated by blanks.
  std::string codes_of(const Warnings &warnings);
} // namespace abut
