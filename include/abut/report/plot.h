// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/apart.h>

#include <string>
#include <vector>

namespace abut
{
  /// One curve of a diagram.
  struct Curve
  {
    std::string name; ///< in the legend
    Polyline points;
    enum class Style
    {
      line,
      dashed,
      marks ///< points joined by a thin line
    } style = Style::marks;
  };

  struct Axis
  {
    std::string label;
    bool logarithmic = false;
    bool has_zero = false; ///< zero is in the range, whatever the values are
  };

  /// A diagram with one legend for all of its curves.
  struct Plot
  {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
  };

  /**
   * Diagrams side by side, as the content of an SVG file. Points that are not finite are left out, on
   * logarithmic axes those that are not above 0 as well.
   */
  std::string plots(const std::vector<Plot> &diagrams);
} // namespace abut
