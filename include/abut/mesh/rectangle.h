// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

#include <functional>

namespace abut
{
  /// n + 1 numbers from 0 to 1, whose differences form a geometric progression with last = grading * first.
  std::vector<double> graded(unsigned int n, double grading);

  /// Size[0] wide, its columns of cells stretched from y = 0 to the height at their x; graded.
  RawMesh rectangle_below(const BodyDescription &body, const std::function<double(double x)> &height);
} // namespace abut
