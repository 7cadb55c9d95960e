// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut::testing
{
  /// A CSV file with texts in quotation marks. What is asked for must be there (std::out_of_range).
  class CsvFile
  {
  public:
    explicit CsvFile(const std::string &path);

    const std::vector<std::string> &columns() const { return columns_; }
    std::size_t n_rows() const { return rows_.size(); }
    const std::string &text(std::size_t row, const std::string &column) const;
    /// Not a number where the cell is empty.
    double number(std::size_t row, const std::string &column) const;

  private:
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
  };

  /// How often a text has a part.
  std::size_t occurrences(const std::string &text, const std::string &part);
} // namespace abut::testing
