// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// The perceptually uniform colour map "viridis" (S. van der Walt, N. Smith, CC0): 0 dark blue, 1 yellow;
  /// as "#rrggbb". Values outside are cut off.
  std::string viridis(double value);
} // namespace abut
