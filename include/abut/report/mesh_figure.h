// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/deformed.h>

#include <string>
#include <vector>

namespace abut
{
  /// One mesh of a figure, with a line of text above it.
  struct MeshPanel
  {
    std::string caption;
    const DrawnBody *body = nullptr;
    bool coloured = false; ///< by the von Mises stress
  };

  /// The content of an SVG file: meshes below one another in one scale, below them the colours' scale where
  /// one of them is coloured. There is at least one mesh, and it has cells.
  std::string mesh_figure(const std::vector<MeshPanel> &panels);
} // namespace abut
