// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/text.h>
#include <abut/scene/goal.h>

#include <regex>

namespace abut
{
  std::string Goal::text() const
  {
    switch (kind)
    {
    case Kind::energy:
      return "energy";
    case Kind::force:
      return "force";
    case Kind::peak_pressure:
      return "peak pressure";
    case Kind::stress:
      return "stress at (" + exact_number(point.x()) + ", " + exact_number(point.y()) + ")";
    }
    return {};
  }

  Goal Goal::parse(const std::string &text)
  {
    if (text == "energy")
      return {};
    if (text == "force")
      return {Kind::force};
    if (text == "peak pressure")
      return {Kind::peak_pressure};
    static const std::string number = "\\s*([-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][-+]?[0-9]{1,2})?)\\s*";
    static const std::regex at_point("stress\\s+at\\s*\\(" + number + "," + number + "\\)");
    if (std::smatch found; std::regex_match(text, found, at_point))
      return {Kind::stress, Vector2(std::stod(found[1]), std::stod(found[2]))};
    throw UserError("Goal: received `" + text +
                    "`, allowed are energy, force, peak pressure, stress at (x, y)");
  }
} // namespace abut
