// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <string>

namespace abut
{
  /// Whether the scene has at most 40 000 cells: more no viewer likes.
  bool fits_a_picture(const Results &results);

  /// The content of solution.svg: the bodies as `scene` (see `deformed_scene`) has them, with their cells
  /// filled by the mean von Mises stress, and the contact pressure in red along the slave sides.
  std::string picture(const Results &results, const DrawnScene &scene);
} // namespace abut
