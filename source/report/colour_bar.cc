// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/colour_bar.h>
#include <abut/report/colour_map.h>
#include <abut/report/svg.h>

#include <algorithm>
#include <ostream>

namespace abut
{
  void ColourRange::include(const std::vector<double> &values)
  {
    for (const double value : values)
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }

  std::string ColourRange::colour(const double value) const
  {
    return viridis(high > low ? (value - low) / (high - low) : 0.);
  }

  void write_colour_bar(std::ostream &out, const ColourRange &range, const Vector2 &corner,
                        const std::string &title)
  {
    constexpr int n_ticks = 6; // the smallest and the largest value and four between
    out << "<defs><linearGradient id=\"stress\">\n";
    for (int i = 0; i <= 20; ++i)
      out << "<stop offset=\"" << 5 * i << "%\" stop-color=\"" << viridis(.05 * i) << "\"/>\n";
    out << "</linearGradient></defs>\n<rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\""
        << colour_bar_width << "\" height=\"" << colour_bar_height << "\" fill=\"url(#stress)\"/>\n";
    for (int i = 0; i < n_ticks; ++i)
    {
      const double share = static_cast<double>(i) / (n_ticks - 1);
      const Vector2 place = corner + Vector2(share * colour_bar_width, colour_bar_height);
      out << "<path stroke=\"#333\" d=\"M" << place.x() << ' ' << place.y() << "v5\"/>\n";
      write_text(out, place + Vector2(0., 19.), Anchor::middle,
                 short_number(range.low + share * (range.high - range.low), 3));
    }
    write_text(out, corner + Vector2(0., -7.), Anchor::start, title);
  }
} // namespace abut
