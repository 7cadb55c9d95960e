// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/counts.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_tools.h>

namespace abut
{
  Counts count(const Space &space)
  {
    return {space.mesh().triangulation.n_active_cells(), space.dof_handler().n_dofs(),
            dealii::DoFTools::extract_boundary_dofs(space.dof_handler()).n_elements()};
  }

  Counts operator+(const Counts &a, const Counts &b)
  {
    return {a.cells + b.cells, a.dofs + b.dofs, a.boundary_dofs + b.boundary_dofs};
  }
} // namespace abut
