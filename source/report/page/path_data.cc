// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/path_data.h>

#include <charconv>
#include <cmath>

namespace abut
{
  UnitPoints unit_points(const Polyline &points, const PageFrame &frame)
  {
    UnitPoints places;
    for (const Vector2 &point : points)
    {
      const Vector2 place = frame(point);
      places.push_back({static_cast<int>(std::lround(place.x())), static_cast<int>(std::lround(place.y()))});
    }
    return places;
  }

  void PathData::add_closed(const UnitPoints &points)
  {
    add_open(points);
    command('z');
  }

  void PathData::add_open(const UnitPoints &points)
  {
    command('m');
    pair(points.front() - pen_);
    pen_ = points.front();
    for (std::size_t i = 1; i < points.size(); ++i)
      line(points[i] - points[i - 1]);
  }

  void PathData::line(const UnitPoint &step)
  {
    if (step.y == 0)
    {
      command('h');
      number(step.x);
    }
    else if (step.x == 0)
    {
      command('v');
      number(step.y);
    }
    else
    {
      if (command_ != 'm' && command_ != 'l') // pairs after `m` are lines too
        command('l');
      pair(step);
    }
  }

  void PathData::pair(const UnitPoint &step)
  {
    number(step.x);
    number(step.y);
  }

  void PathData::command(const char c)
  {
    text_ += c;
    command_ = c;
  }

  void PathData::number(const int value)
  {
    char digits[16];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    if (value >= 0 && text_.back() >= '0' && text_.back() <= '9')
      text_ += ' ';
    text_.append(digits, end);
  }

  std::string short_path(const Polyline &points, const PageFrame &frame, const bool closed)
  {
    PathData path;
    if (closed)
      path.add_closed(unit_points(points, frame));
    else
      path.add_open(unit_points(points, frame));
    return path.text();
  }
} // namespace abut
