// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

#include <map>
#include <tuple>
#include <vector>

namespace abut
{
  /// A vertex of a mesh with the material (its id) of the cells around it that are meant: stresses jump where
  /// another one begins.
  struct PatchCentre
  {
    unsigned int vertex;
    dealii::types::material_id material;

    bool operator<(const PatchCentre &other) const
    {
      return std::tie(vertex, material) < std::tie(other.vertex, other.material);
    }
  };

  /**
   * The cells of one material around each vertex of a mesh; a hanging vertex counts the coarse cell on whose
   * face it lies. Where these are fewer than `fewest`, as on the boundary, the patch takes the cells around
   * their vertices too.
   */
  std::map<PatchCentre, std::vector<Cell>> vertex_patches(const Space &space, std::size_t fewest);
} // namespace abut
