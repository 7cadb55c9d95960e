// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/cell_marks.h>

#include <deal.II/grid/tria.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr int deepest_level = 30;
  } // namespace

  bool CellMarks::any() const
  {
    return std::count(refine.begin(), refine.end(), true) + std::count(coarsen.begin(), coarsen.end(), true) >
           0;
  }

  CellMarks no_marks(const std::size_t n_cells)
  {
    const std::vector<bool> none(n_cells, false);
    return {none, none};
  }

  CellMarks no_marks(const dealii::Triangulation<2> &triangulation)
  {
    return no_marks(triangulation.n_active_cells());
  }

  void set_flags(dealii::Triangulation<2> &triangulation, const CellMarks &marks)
  {
    AssertDimension(marks.refine.size(), triangulation.n_active_cells());
    AssertDimension(marks.coarsen.size(), triangulation.n_active_cells());
    const bool triangles = !triangulation.all_reference_cells_are_hyper_cube();
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      const unsigned int index = cell->active_cell_index();
      if (marks.refine[index] && cell->level() < deepest_level)
        cell->set_refine_flag();
      else if (marks.coarsen[index] && cell->level() > 0 && !triangles)
        cell->set_coarsen_flag();
    }
  }
} // namespace abut
