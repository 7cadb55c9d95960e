// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  // Pieces of report.html. The page is HTML and well-formed XML at once.

  /// A number for people, its exact value in the attribute `value` beside it; "-" where it is not finite.
  std::string html_number(double value, int digits = 4);
  /// "not estimated" and the like where there is none.
  std::string html_number(const std::optional<double> &value, const std::string &otherwise, int digits = 4);
  /// In per cent, the exact value as it is.
  std::string html_percent(double share, int digits = 3);
  std::string html_percent(const std::optional<double> &share, const std::string &otherwise, int digits = 3);

  /// Cells are HTML; the first one of a row is its heading.
  struct HtmlTable
  {
    std::string caption;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
  };

  /// Of many rows the first and the last hundred, and between them how many are left out.
  void write_table(std::ostream &out, const HtmlTable &table);
} // namespace abut
