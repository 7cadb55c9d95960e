// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

#include <string>
#include <utility>
#include <vector>

namespace abut
{
  /// How large the cells of a meshed geometry are to be; lengths of the own frame. Away from where it is
  /// asked for, a local size grows by a quarter of the distance.
  struct MeshSize
  {
    double everywhere = 0.; ///< at most; 0: what the geometry says, or a tenth of its diagonal
    std::vector<std::pair<std::string, double>> on_sides;
    std::vector<std::pair<Vector2, double>> at_points;

    bool is_given() const { return everywhere > 0. || !on_sides.empty() || !at_points.empty(); }
  };

  /// `2; bore: 0.5; (10, 0): 0.1`. Throws UserError, beginning with `where`.
  MeshSize parse_mesh_size(const std::string &text, const Constants &constants, const std::string &where);
} // namespace abut
