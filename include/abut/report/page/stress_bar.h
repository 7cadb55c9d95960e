// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/colour_bar.h>
#include <abut/report/page/pass_drawings.h>

#include <iosfwd>

namespace abut
{
  /// What the colours of all pictures stand for, and the largest value of all.
  struct StressRange
  {
    ColourRange colours; ///< values above have the last colour
    double largest = 0.;
  };

  /// All values, unless singular peaks would leave one colour for the rest: where the largest is more than
  /// three times what 99.5 % of the last drawing's area stay below, the range ends at twice that.
  StressRange stress_range_of(const std::vector<PassDrawing> &drawings);

  void write_stress_bar(std::ostream &out, const StressRange &range);
} // namespace abut
