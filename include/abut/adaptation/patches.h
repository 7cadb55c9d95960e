// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <map>
#include <vector>

namespace abut
{
  /**
   * The cells around each vertex of a mesh, by vertex index; a hanging vertex counts the coarse cell on whose
   * face it lies. Where these are fewer than `fewest`, as on the boundary, the patch takes the cells around
   * their vertices too.
   */
  std::map<unsigned int, std::vector<Cell>> vertex_patches(const Space &space, std::size_t fewest);
} // namespace abut
