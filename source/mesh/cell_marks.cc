// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/cell_marks.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr int deepest_level = 30;

    /// Flags the coarser neighbours of flagged cells until there are none.
    void flag_coarser_neighbours(dealii::Triangulation<2> &triangulation)
    {
      for (bool changed = true; changed;)
      {
        changed = false;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->refine_flag_set())
            for (const unsigned int f : cell->face_indices())
              if (!cell->at_boundary(f) && cell->neighbor(f)->is_active() &&
                  cell->neighbor(f)->level() < cell->level() && !cell->neighbor(f)->refine_flag_set())
              {
                cell->neighbor(f)->set_refine_flag();
                changed = true;
              }
      }
    }
  } // namespace

  bool CellMarks::any() const
  {
    return std::count(refine.begin(), refine.end(), true) + std::count(coarsen.begin(), coarsen.end(), true) >
           0;
  }

  CellMarks no_marks(const dealii::Triangulation<2> &triangulation)
  {
    const std::vector<bool> none(triangulation.n_active_cells(), false);
    return {none, none};
  }

  void set_flags(dealii::Triangulation<2> &triangulation, const CellMarks &marks)
  {
    const bool triangles = !triangulation.all_reference_cells_are_hyper_cube();
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      const unsigned int index = cell->active_cell_index();
      if (marks.refine[index] && cell->level() < deepest_level)
        cell->set_refine_flag();
      else if (marks.coarsen[index] && cell->level() > 0 && !triangles)
        cell->set_coarsen_flag();
    }
    if (triangles)
      flag_coarser_neighbours(triangulation);
  }
} // namespace abut
