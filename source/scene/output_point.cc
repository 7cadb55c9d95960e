// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/text.h>
#include <abut/base/user_error.h>
#include <abut/scene/output_point.h>

#include <regex>

namespace abut
{
  std::optional<Vector2> point_of(const std::string &text)
  {
    static const std::string number = "\\s*([-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][-+]?[0-9]{1,2})?)\\s*";
    static const std::regex point("\\(" + number + "," + number + "\\)");
    if (std::smatch found; std::regex_match(text, found, point))
      return Vector2(std::stod(found[1]), std::stod(found[2]));
    return {};
  }

  std::vector<OutputPoint> parse_output_points(const std::string &text)
  {
    std::vector<OutputPoint> points;
    if (trim(text).empty())
      return points;
    for (const std::string &piece : split_outside_parentheses(text, ';'))
    {
      const std::size_t colon = piece.find(':');
      const bool names_body = colon != std::string::npos;
      const auto place = point_of(trim(names_body ? piece.substr(colon + 1) : piece));
      if (!place)
        throw UserError("Output/Points: received `" + piece +
                        "`, allowed are (x, y) and body: (x, y) with two numbers, separated by semicolons");
      points.push_back({names_body ? trim(piece.substr(0, colon)) : "", *place});
    }
    return points;
  }
} // namespace abut
