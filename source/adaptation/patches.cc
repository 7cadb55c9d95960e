// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/patches.h>

#include <set>

namespace abut
{
  namespace
  {
    using Patches = std::map<PatchCentre, std::set<Cell>>;

    /// Adds to the patches of hanging vertices the coarse cells that they hang on.
    void add_coarse_cells(const Cell &cell, Patches &patches)
    {
      for (const unsigned int f : cell->face_indices())
      {
        if (cell->at_boundary(f) || cell->neighbor(f)->level() >= cell->level())
          continue;
        const Cell coarse = cell->neighbor(f);
        for (const unsigned int end : {0u, 1u})
          patches[{cell->face(f)->vertex_index(end), coarse->material_id()}].insert(coarse);
      }
    }
  } // namespace

  std::map<PatchCentre, std::vector<Cell>> vertex_patches(const Space &space, const std::size_t fewest)
  {
    Patches patches;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      for (const unsigned int v : cell->vertex_indices())
        patches[{cell->vertex_index(v), cell->material_id()}].insert(cell);
      add_coarse_cells(cell, patches);
    }
    std::map<PatchCentre, std::vector<Cell>> result;
    for (const auto &[centre, cells] : patches)
    {
      std::set<Cell> patch = cells;
      if (patch.size() < fewest)
        for (const Cell &cell : cells)
          for (const unsigned int v : cell->vertex_indices())
          {
            const std::set<Cell> &more = patches.at({cell->vertex_index(v), centre.material});
            patch.insert(more.begin(), more.end());
          }
      result[centre].assign(patch.begin(), patch.end());
    }
    return result;
  }
} // namespace abut
