// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/colour_map.h>
#include <abut/report/page/stress_bar.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace abut
{
  namespace
  {
    constexpr double usual_share = .995;

    double area_of(const Polyline &outline)
    {
      double twice = 0.;
      for (std::size_t i = 0; i < outline.size(); ++i)
      {
        const Vector2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        twice += a.x() * b.y() - a.y() * b.x();
      }
      return .5 * std::abs(twice);
    }

    /// What the given share of the area stays below.
    double usual_stress(const DrawnScene &scene)
    {
      std::vector<std::pair<double, double>> stress_and_area;
      double all = 0.;
      for (const DrawnBody &body : scene.bodies)
        for (std::size_t i = 0; i < body.von_mises.size(); ++i)
        {
          stress_and_area.emplace_back(body.von_mises[i], area_of(body.cells[i]));
          all += stress_and_area.back().second;
        }
      std::sort(stress_and_area.begin(), stress_and_area.end());
      double sum = 0.;
      for (const auto &[stress, area] : stress_and_area)
        if ((sum += area) >= usual_share * all)
          return stress;
      return 0.;
    }
  } // namespace

  StressRange stress_range_of(const std::vector<PassDrawing> &drawings)
  {
    StressRange range;
    for (const PassDrawing &drawing : drawings)
      for (const DrawnBody &body : drawing.scene.bodies)
        range.colours.include(body.von_mises);
    range.largest = range.colours.high;
    const double usual = usual_stress(drawings.back().scene);
    if (usual > 0. && range.largest > 3. * usual)
      range.colours.high = 2. * usual;
    return range;
  }

  void write_stress_bar(std::ostream &out, const StressRange &range)
  {
    constexpr int n_ticks = 5;
    constexpr double left = 40., length = 400.;
    const ColourRange &colours = range.colours;
    const bool cut = colours.high < range.largest;
    if (!std::isfinite(colours.low))
      return; // rigid bodies alone
    const std::string largest = short_number(range.largest, 3);
    out << "<svg class=\"scale\" role=\"img\" aria-label=\"Colours of the von Mises stress from "
        << short_number(colours.low, 3) << " to " << short_number(colours.high, 3)
        << "\" viewBox=\"0 0 480 62\">\n<defs><linearGradient id=\"stress\">";
    for (int i = 0; i <= 20; ++i)
      out << "<stop offset=\"" << 5 * i << "%\" stop-color=\"" << viridis(.05 * i) << "\"/>";
    out << "</linearGradient></defs>\n<text x=\"" << left << "\" y=\"13\">von Mises stress, mean of each cell"
        << (cut ? "; up to " + largest + " in the last colour" : "") << "</text>\n<rect x=\"" << left
        << "\" y=\"20\" width=\"" << length << "\" height=\"14\" fill=\"url(#stress)\"/>\n";
    for (int i = 0; i < n_ticks; ++i)
    {
      const double share = static_cast<double>(i) / (n_ticks - 1), x = left + length * share;
      out << "<path class=\"tick\" d=\"M" << x << " 34v5\"/><text x=\"" << x
          << "\" y=\"53\" text-anchor=\"middle\">"
          << short_number(colours.low + share * (colours.high - colours.low), 3) << "</text>\n";
    }
    out << "</svg>\n";
  }
} // namespace abut
