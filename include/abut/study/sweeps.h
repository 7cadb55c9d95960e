// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/table.h>
#include <abut/study/study_lines.h>

namespace abut
{
  /// Quantities against the number that a sweep changes, at the last pass of every variant.
  struct Sweep
  {
    StudyAxis parameter;          ///< `Section/Name`
    std::vector<StudyLine> lines; ///< one for all that else is the same, by growing number
  };

  /// The parameters that are swept, in their order.
  std::vector<std::string> swept_parameters(const std::vector<StudyRun> &runs);

  /// The contacts of all variants.
  std::vector<std::string> contact_names(const std::vector<StudyRun> &runs);

  /// The points of all variants, by body and number.
  std::vector<std::string> point_names(const std::vector<StudyRun> &runs);

  /// Of the swept parameters those whose values differ in one number (number_that_differs).
  std::vector<Sweep> sweeps(const std::vector<StudyRun> &runs);

  /// What a diagram shows against them: force, pressure and length where some variant has a contact.
  std::vector<StudyAxis> known_quantities(const std::vector<StudyRun> &runs);

  /// A row for each variant, its last pass: the swept values, the load case and the name of the variant where
  /// there are such, then the quantities.
  TextTable quantity_table(const std::vector<StudyRun> &runs);

  /// Its title, which says what stands in it where there are several contacts.
  std::string quantity_title(const std::vector<StudyRun> &runs);
} // namespace abut
