// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// A text as it is to be read in Markdown: `<`, `*` and `|` mean themselves; what stands in backticks
  /// stays.
  std::string markdown(const std::string &text);

  /// In backticks; empty for an empty text.
  std::string code(const std::string &text);

  /// A line of a table, for cells that are Markdown already.
  std::string table_row(const std::vector<std::string> &cells);

  /// The first two lines of a table.
  std::string table_head(const std::vector<std::string> &columns);
} // namespace abut
