// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

namespace abut
{
  /**
   * Reads `body.mesh_path`, a Gmsh file (.msh, ASCII, versions 1 to 4.1) of quadrilaterals or of triangles of
   * first order in the plane z = 0. Its physical lines are the sides, called by their ids; edges of the
   * boundary that are on none form the side "0". Throws UserError with the file's name: unreadable or empty,
   * mixed or
   * distorted cells, z not zero, several parts, no physical line on the boundary.
   */
  RawMesh read_mesh_file(const BodyDescription &body);
} // namespace abut
