// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/page/pass_drawings.h>
#include <abut/results/results.h>

#include <iosfwd>

namespace abut
{
  /// The part of report.html with the deformed bodies: a figure for each drawing, all of one scale and one
  /// colour bar, the last one open; what is left out of them in words.
  void write_pictures(std::ostream &out, const Results &results, const std::vector<PassDrawing> &drawings);
} // namespace abut
