// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace abut
{
  std::string trim(const std::string &text)
  {
    constexpr auto white_space = " \t\r\n\v\f";
    const auto first = text.find_first_not_of(white_space);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(white_space) - first + 1);
  }

  std::vector<std::string> split_outside_parentheses(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces(1);
    int depth = 0;
    for (const char c : text)
    {
      depth += (c == '(') - (c == ')');
      if (c == separator && depth == 0)
        pieces.emplace_back();
      else
        pieces.back() += c;
    }
    for (auto &piece : pieces)
      piece = trim(piece);
    return pieces;
  }

  std::string name_of_sides(const std::string &text)
  {
    std::string name;
    for (const std::string &side : split_outside_parentheses(text, '+'))
    {
      if (side.empty())
        return trim(text); // `x+` is a name
      name += (name.empty() ? "" : " + ") + side;
    }
    return name;
  }

  std::string one_line(const dealii::ExceptionBase &exception)
  {
    std::stringstream words;
    exception.print_info(words);
    std::string line;
    for (std::string word; words >> word;)
      line += (line.empty() ? "" : " ") + word;
    if (!line.empty() && line.back() == '.')
      line.pop_back();
    return line;
  }
} // namespace abut
