// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/svg.h>

#include <string>
#include <vector>

namespace abut
{
  /// A place in a drawing's own unit.
  struct UnitPoint
  {
    int x = 0, y = 0;
  };
  using UnitPoints = std::vector<UnitPoint>;

  inline UnitPoint operator-(const UnitPoint &a, const UnitPoint &b)
  {
    return {a.x - b.x, a.y - b.y};
  }

  /// The nearest whole units. `frame`: into units.
  UnitPoints unit_points(const Polyline &points, const PageFrame &frame);

  /// The data of an SVG path, as short as may be: each point relative to the one before, lines along the axes
  /// with one number.
  class PathData
  {
  public:
    /// A closed line through the points.
    void add_closed(const UnitPoints &points);
    /// An open one; nothing may be added behind it.
    void add_open(const UnitPoints &points);
    const std::string &text() const { return text_; }

  private:
    void line(const UnitPoint &step);
    void pair(const UnitPoint &step);
    void command(char c);
    void number(int value);

    std::string text_;
    UnitPoint pen_; ///< the beginning of the last line
    char command_ = 'm';
  };

  /// Of one line alone.
  std::string short_path(const Polyline &points, const PageFrame &frame, bool closed);
} // namespace abut
