// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_files.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace abut::testing
{
  namespace
  {
    std::vector<std::string> quoted_cells(const std::string &line)
    {
      std::vector<std::string> result(1);
      bool quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
          result.back() += line[++i];
        else if (line[i] == '"')
          quoted = !quoted;
        else if (line[i] == ',' && !quoted)
          result.emplace_back();
        else
          result.back() += line[i];
      return result;
    }
  } // namespace

  CsvFile::CsvFile(const std::string &path)
  {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line))
      throw std::out_of_range("no file " + path);
    columns_ = quoted_cells(line);
    while (std::getline(file, line))
    {
      rows_.push_back(quoted_cells(line));
      if (rows_.back().size() != columns_.size())
        throw std::out_of_range("a row of another length: " + line);
    }
  }

  const std::string &CsvFile::text(const std::size_t row, const std::string &column) const
  {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end())
      throw std::out_of_range("no column " + column);
    return rows_.at(row)[static_cast<std::size_t>(found - columns_.begin())];
  }

  double CsvFile::number(const std::size_t row, const std::string &column) const
  {
    const std::string &cell = text(row, column);
    return cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell);
  }

  std::size_t occurrences(const std::string &text, const std::string &part)
  {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++n;
    return n;
  }
} // namespace abut::testing
