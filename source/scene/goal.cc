// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/base/user_error.h>
#include <abut/scene/goal.h>
#include <abut/scene/output_point.h>

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
    static const std::regex at_point("stress\\s+at\\s*(\\(.*\\))");
    if (std::smatch found; std::regex_match(text, found, at_point))
      if (const auto point = point_of(found[1]))
        return {Kind::stress, *point};
    throw UserError("Goal: received `" + text +
                    "`, allowed are energy, force, peak pressure, stress at (x, y)");
  }
} // namespace abut
