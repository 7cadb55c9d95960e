// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/repeated_parameters.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace abut
{
  namespace
  {
    /// A line of a parameter file without its comment, joined with those that continue it.
    struct LogicalLine
    {
      std::string text;
      unsigned int number; ///< of the first of them
    };

    std::vector<LogicalLine> logical_lines(const std::string &text)
    {
      std::vector<LogicalLine> lines;
      std::istringstream stream(text);
      bool continued = false;
      unsigned int number = 0;
      for (std::string line; std::getline(stream, line);)
      {
        ++number;
        line.erase(line.find_last_not_of(" \t") + 1);
        const bool goes_on = !line.empty() && line.back() == '\\';
        if (goes_on)
          line.pop_back();
        if (continued)
          lines.back().text += line;
        else
          lines.push_back({line, number});
        continued = goes_on;
      }
      for (LogicalLine &line : lines)
        line.text.erase(std::min(line.text.find('#'), line.text.size()));
      return lines;
    }

    /// The words up to `end`, one blank between them.
    std::string words(std::istringstream &stream, const char end)
    {
      std::string all, word, result;
      std::getline(stream, all, end);
      for (std::istringstream parts(all); parts >> word;)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }
  } // namespace

  std::vector<RepeatedParameter> repeated_parameters(const std::string &text)
  {
    std::vector<std::string> sections;
    std::map<std::string, RepeatedParameter> found;
    for (const LogicalLine &line : logical_lines(text))
    {
      std::istringstream stream(line.text);
      std::string command;
      stream >> command;
      std::transform(command.begin(), command.end(), command.begin(),
                     [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (command == "subsection")
        sections.push_back(words(stream, '\n'));
      else if (command == "end" && !sections.empty())
        sections.pop_back();
      else if (command == "set")
      {
        std::string name;
        for (const std::string &section : sections)
          name += section + "/";
        name += words(stream, '=');
        found.try_emplace(name, RepeatedParameter{name, line.number, 0}).first->second.last_line =
            line.number;
      }
    }
    std::vector<RepeatedParameter> repeated;
    for (const auto &[name, parameter] : found)
      if (parameter.last_line > parameter.first_line)
        repeated.push_back(parameter);
    std::sort(repeated.begin(), repeated.end(), [](const RepeatedParameter &a, const RepeatedParameter &b) {
      return a.last_line < b.last_line;
    });
    return repeated;
  }
} // namespace abut
