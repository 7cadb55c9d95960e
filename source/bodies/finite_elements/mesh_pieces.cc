// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/mesh_pieces.h>

#include <numeric>

namespace abut
{
  std::vector<std::vector<unsigned int>> mesh_pieces(const Space &space)
  {
    const dealii::Triangulation<2> &triangulation = space.mesh().triangulation;
    std::vector<unsigned int> all(triangulation.n_active_cells());
    std::iota(all.begin(), all.end(), 0u);
    if (space.glued_sides().empty())
      return {all};
    // On the coarsest mesh, where all cells of a piece are neighbours; the others descend from these.
    std::vector<int> piece_of(triangulation.n_cells(0), -1);
    std::vector<std::vector<unsigned int>> pieces;
    for (const auto &first : triangulation.cell_iterators_on_level(0))
    {
      if (piece_of[static_cast<std::size_t>(first->index())] >= 0)
        continue;
      const int piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
      std::vector<dealii::Triangulation<2>::cell_iterator> waiting{first};
      piece_of[static_cast<std::size_t>(first->index())] = piece;
      while (!waiting.empty())
      {
        const auto cell = waiting.back();
        waiting.pop_back();
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f))
            if (int &known = piece_of[static_cast<std::size_t>(cell->neighbor(f)->index())]; known < 0)
            {
              known = piece;
              waiting.push_back(cell->neighbor(f));
            }
      }
    }
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      dealii::Triangulation<2>::cell_iterator ancestor = cell;
      while (ancestor->level() > 0)
        ancestor = ancestor->parent();
      pieces[static_cast<std::size_t>(piece_of[static_cast<std::size_t>(ancestor->index())])].push_back(
          cell->active_cell_index());
    }
    return pieces;
  }
} // namespace abut
