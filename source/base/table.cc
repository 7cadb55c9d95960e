// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/table.h>

#include <algorithm>

namespace abut
{
  TextTable without_empty_columns(const TextTable &table)
  {
    TextTable kept(table.size());
    for (std::size_t column = 0; column < table.front().size(); ++column)
    {
      if (std::all_of(table.begin() + 1, table.end(), [&](const auto &row) { return row[column] == "-"; }))
        continue;
      for (std::size_t row = 0; row < table.size(); ++row)
        kept[row].push_back(table[row][column]);
    }
    return kept;
  }
} // namespace abut
