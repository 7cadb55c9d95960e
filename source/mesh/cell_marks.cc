// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/gathered.h>
#include <abut/mesh/cell_marks.h>
#include <abut/mesh/own_cells.h>

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
    return {none, none, {}};
  }

  CellMarks no_marks(const dealii::Triangulation<2> &triangulation)
  {
    return no_marks(triangulation.n_global_active_cells());
  }

  void set_flags(dealii::Triangulation<2> &triangulation, const CellMarks &marks,
                 const unsigned int first_level)
  {
    AssertDimension(marks.refine.size(), triangulation.n_global_active_cells());
    AssertDimension(marks.coarsen.size(), triangulation.n_global_active_cells());
    const bool triangles = !triangulation.all_reference_cells_are_hyper_cube();
    for (const auto &cell : own_cells(triangulation))
    {
      const auto index = cell->global_active_cell_index();
      if (marks.refine[index] && cell->level() < deepest_level)
        cell->set_refine_flag();
      else if (marks.coarsen[index] && cell->level() > static_cast<int>(first_level) && !triangles)
        cell->set_coarsen_flag();
    }
  }

  namespace
  {
    /// Flags what lies across a border between materials from a cell that is split; whether there was some.
    bool split_across_borders(const dealii::Triangulation<2>::active_cell_iterator &cell)
    {
      bool some = false;
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->is_active() &&
            cell->neighbor(f)->material_id() != cell->material_id())
        {
          const auto across = cell->neighbor(f);
          cell->clear_coarsen_flag();
          if (cell->refine_flag_set() && !across->refine_flag_set() && across->level() <= cell->level())
          {
            across->clear_coarsen_flag();
            across->set_refine_flag();
            some = true;
          }
        }
      return some;
    }
  } // namespace

  void complete_flags(dealii::Triangulation<2> &triangulation, const bool curved_borders)
  {
    for (bool some = true; some;)
    {
      triangulation.prepare_coarsening_and_refinement();
      some = false;
      if (curved_borders)
        for (const auto &cell : triangulation.active_cell_iterators())
          some = split_across_borders(cell) || some;
    }
  }

  namespace
  {
    Vector2 to_vector(const dealii::Point<2> &point)
    {
      return {point[0], point[1]};
    }

    /// Whether a place is a vertex of a cell, or lies on an edge of it at the boundary.
    bool touches(const dealii::Triangulation<2>::active_cell_iterator &cell, const Vector2 &place)
    {
      constexpr double round_off = 1e-8, bent = 1.02; // an edge's chord is shorter than its curve
      const double diameter = cell->diameter();
      for (const unsigned int v : cell->vertex_indices())
        if ((to_vector(cell->vertex(v)) - place).norm() < round_off * diameter)
          return true;
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
        {
          const Vector2 start = to_vector(cell->face(f)->vertex(0)),
                        end = to_vector(cell->face(f)->vertex(1));
          if ((start - place).norm() + (end - place).norm() < bent * (end - start).norm())
            return true;
        }
      return false;
    }
  } // namespace

  void grade(dealii::Triangulation<2> &triangulation, const std::vector<Grading> &gradings,
             const bool curved_borders, const std::shared_ptr<Processes> &processes)
  {
    for (unsigned int round = 0;; ++round)
    {
      bool some = false;
      for (const auto &cell : own_cells(triangulation))
        if (cell->level() < deepest_level &&
            std::any_of(gradings.begin(), gradings.end(), [&](const Grading &grading) {
              return round < grading.further && touches(cell, grading.place);
            }))
        {
          cell->set_refine_flag();
          some = true;
        }
      if (!in_any(processes, some))
        return;
      complete_flags(triangulation, curved_borders);
      triangulation.execute_coarsening_and_refinement();
    }
  }
} // namespace abut
