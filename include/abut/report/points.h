// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/json.h>
#include <abut/results/point_result.h>

#include <string>
#include <vector>

namespace abut
{
  /// The content of points.csv: a row for each point and body that has it, see the reference.
  std::string points_csv(const std::vector<PointResult> &points);

  /// The same in summary.json.
  Json points_summary(const std::vector<PointResult> &points);
} // namespace abut
