// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/repeated_parameters.h>

#include <algorithm>
#include <map>

namespace abut
{
  std::vector<RepeatedParameter> repeated_parameters(const std::vector<ParameterLine> &lines)
  {
    std::map<std::string, RepeatedParameter> found;
    for (const ParameterLine &line : lines)
      if (line.sets && line.number > 0)
      {
        const std::string name = line.sections.empty() ? line.name : line.section() + "/" + line.name;
        found.try_emplace(name, RepeatedParameter{name, line.number, 0}).first->second.last_line =
            line.number;
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
