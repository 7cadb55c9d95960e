// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/colour_bar.h>
#include <abut/report/deformed.h>
#include <abut/report/svg.h>

#include <iosfwd>

namespace abut
{
  constexpr unsigned int n_colour_classes = 32;

  /**
   * Writes the bodies' cells as SVG, short: one path for each class of colours, whole numbers relative to the
   * point before. `frame`: into these whole units. Cells that are smaller than `square` units either way are
   * drawn together, as squares of that size with the mean stress of the cells whose middles they hold.
   */
  void write_cell_paths(std::ostream &out, const DrawnScene &scene, const ColourRange &range,
                        const PageFrame &frame, int square);

  /// How many cells are smaller than `square` units either way.
  std::size_t small_cells(const DrawnScene &scene, const PageFrame &frame, int square);
} // namespace abut
