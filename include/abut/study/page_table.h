// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/table.h>
#include <abut/study/study_data.h>

namespace abut
{
  /// The table of all passes in study.html: the columns that hold something. Those that a sheet of paper has
  /// no room for are left out in print.
  std::string passes_table(const StudyData &data);

  /// Any other, of texts and numbers.
  std::string html_table(const TextTable &table);
} // namespace abut
