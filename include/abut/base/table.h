// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// Rows of cells, the headings first.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Without the columns that have `-`, which stands for what is not known, in all rows below the heading.
  TextTable without_empty_columns(const TextTable &table);
} // namespace abut
