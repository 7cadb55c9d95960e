// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

#include <array>
#include <functional>

namespace abut
{
  /// n + 1 numbers from 0 to 1, whose differences form a geometric progression with last = grading * first.
  std::vector<double> graded(unsigned int n, double grading);

  /// See ShapeEntry; two cells across the shorter side.
  std::array<unsigned int, 2> coarse_cells_of_rectangle(const std::vector<double> &size);

  /// Size[0] wide, its columns of cells stretched from y = 0 to the height at their x; graded.
  RawMesh rectangle_below(const BodyDescription &body, const std::function<double(double x)> &height);
} // namespace abut
