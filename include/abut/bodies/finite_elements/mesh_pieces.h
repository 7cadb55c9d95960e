// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

namespace abut
{
  /// The pieces of a mesh, of cells that share vertices, by their active indices: one, but for glued bodies.
  std::vector<std::vector<unsigned int>> mesh_pieces(const Space &space);
} // namespace abut
