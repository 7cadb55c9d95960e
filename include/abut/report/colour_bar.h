// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

namespace abut
{
  constexpr double colour_bar_width = 400., colour_bar_height = 14.; ///< pixels

  /// What the colours of a picture stand for: the values between `low` and `high`.
  struct ColourRange
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;

    void include(const std::vector<double> &values);
    std::string colour(double value) const;
  };

  /// The scale of a picture's colours, `corner` its upper left one, with values below and a title above.
  void write_colour_bar(std::ostream &out, const ColourRange &range, const Vector2 &corner,
                        const std::string &title);
} // namespace abut
