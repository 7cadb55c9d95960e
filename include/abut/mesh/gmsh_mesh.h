// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

#include <functional>
#include <string>

namespace abut
{
  /**
   * The mesh of what the Gmsh library holds after `make_model` has filled it, with the curves behind its
   * edges. Physical lines are the sides, called by their numbers and names; edges of the boundary that are on
   * none form the side "0". Throws UserError, beginning with `where`: no cells, solids, z not zero, distorted
   * or folded cells, several parts, no side, or why the library gave up.
   */
  RawMesh mesh_by_gmsh(const BodyDescription &body, const std::string &where,
                       const std::function<void()> &make_model);
} // namespace abut
