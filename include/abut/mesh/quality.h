// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

namespace abut
{
  struct BodyMesh;

  /**
   * Size and shape of cells as the paper measures them. Of all triangles made of three vertices of a cell
   * (four triangles in a quadrilateral) let T_i be the diameters of the circumscribed and t_i of the
   * inscribed circles; the cell has D_e = max T_i and d_e = min t_i.
   */
  struct MeshQuality
  {
    double h_max;      ///< h_F, the largest D_e
    double h_boundary; ///< h_B, the longest edge on the boundary; (22) asks for h_B/h_F between constants
    double regularity; ///< the largest D_e/d_e; 2.414... for squares, 2 for equilateral triangles

    void serialize(Archive &archive) { archive(h_max, h_boundary, regularity); }
  };

  /// Over the active cells.
  MeshQuality mesh_quality(const BodyMesh &mesh);
} // namespace abut
