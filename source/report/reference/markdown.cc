// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/reference/markdown.h>

namespace abut
{
  std::string markdown(const std::string &text)
  {
    std::string result;
    bool in_code = false;
    for (const char c : text)
    {
      in_code = in_code != (c == '`');
      if (c == '<' && !in_code)
        result += "&lt;";
      else if (c == '|' || (c == '*' && !in_code))
        result += std::string("\\") + c;
      else
        result += c;
    }
    return result;
  }

  std::string code(const std::string &text)
  {
    return text.empty() ? "" : markdown("`" + text + "`");
  }

  std::string table_row(const std::vector<std::string> &cells)
  {
    std::string row = "|";
    for (const std::string &cell : cells)
      row += (cell.empty() ? "" : " " + cell) + " |";
    return row + '\n';
  }

  std::string table_head(const std::vector<std::string> &columns)
  {
    std::string line = "|";
    for (std::size_t i = 0; i < columns.size(); ++i)
      line += "---|";
    return table_row(columns) + line + '\n';
  }
} // namespace abut
