// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/plot.h>

#include <iosfwd>

namespace abut
{
  /**
   * A diagram as an SVG element of a page whose style sheet gives the classes `c0` to `c7` colours and
   * dashes, in the order of the curves; a curve without points keeps its class free. A point that is not
   * finite, or not above 0 on a logarithmic axis, interrupts its curve. Points show their values under the
   * mouse.
   */
  void write_diagram(std::ostream &out, const Plot &plot);

  /// What remains visible of a curve with many points: of each of at most `n` groups the lowest and the
  /// highest.
  Polyline thinned(const Polyline &points, std::size_t n);
} // namespace abut
