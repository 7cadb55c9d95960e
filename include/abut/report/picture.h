// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <string>

namespace abut
{
  /**
   * The content of solution.svg: the bodies as `scene` (see `deformed_scene`) has them, with their cells
   * filled by the mean von Mises stress, and the contact pressure in red along the slave sides. Empty above
   * 40 000 cells, which no viewer likes.
   */
  std::string picture(const Results &results, const DrawnScene &scene);
} // namespace abut
