// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/points.h>
#include <abut/report/reference/csv_files.h>

namespace abut
{
  std::string points_csv(const std::vector<PointResult> &points)
  {
    std::string text = csv_header("points.csv");
    for (const PointResult &point : points)
    {
      text += point.body->name() + ',' + std::to_string(point.number);
      const Stress &stress = point.stress;
      for (const double value :
           {point.place.x(), point.place.y(), point.displacement.x(), point.displacement.y(), stress.xx,
            stress.yy, stress.zz, stress.xy, stress.von_mises()})
        text += ',' + exact_number(value);
      text += '\n';
    }
    return text;
  }

  Json points_summary(const std::vector<PointResult> &points)
  {
    Json list = Json::array();
    for (const PointResult &point : points)
      list.push_back({{"body", point.body->name()},
                      {"number", point.number},
                      {"place", {number(point.place.x()), number(point.place.y())}},
                      {"displacement", {number(point.displacement.x()), number(point.displacement.y())}},
                      {"stress_xx", number(point.stress.xx)},
                      {"stress_yy", number(point.stress.yy)},
                      {"stress_zz", number(point.stress.zz)},
                      {"stress_xy", number(point.stress.xy)},
                      {"von_mises", number(point.stress.von_mises())}});
    return list;
  }
} // namespace abut
