// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/adaptation/indicator.h>

namespace abut
{
  /// Takes the difference between a better stress, at SamplePoints::comparison, and the body's own for the
  /// error of the latter.
  CellErrors compare(const BodySolution &solution, const std::vector<Stress> &better);
} // namespace abut
