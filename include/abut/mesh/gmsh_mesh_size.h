// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/mesh_size.h>

#include <string>

namespace abut
{
  /// Tells the library how large the cells of its model are to be. Throws UserError, beginning with `where`,
  /// for a side that the model does not have.
  void set_gmsh_mesh_size(const MeshSize &size, const std::string &where);
} // namespace abut
