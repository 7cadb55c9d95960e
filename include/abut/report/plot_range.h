// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/plot.h>

#include <limits>
#include <vector>

namespace abut
{
  /// The values an axis shows, as they are or as logarithms, and where they lie on the page.
  struct AxisRange
  {
    bool logarithmic = false;
    double low = std::numeric_limits<double>::infinity(), high = -low;

    /// Whether there is a place for the value.
    bool shows(double value) const;
    void include(double value);
    /// Leaves some room at both ends; much where the values are equal up to round-off.
    void widen();
    /// Between 0 and 1 where the value is in the range.
    double share(double value) const;
    /// Round numbers; of a logarithmic axis 1, 2 and 5 times powers of ten, or the powers alone where there
    /// are many.
    std::vector<double> ticks() const;
  };

  struct PlotRange
  {
    AxisRange x, y;

    bool shows(const Vector2 &point) const { return x.shows(point.x()) && y.shows(point.y()); }
  };

  /// What all points of the curves take, and some room.
  PlotRange range_of(const Plot &plot);
} // namespace abut
