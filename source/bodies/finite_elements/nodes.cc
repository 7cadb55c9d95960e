// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/nodes.h>

#include <deal.II/dofs/dof_tools.h>

namespace abut
{
  Nodes all_nodes(const Space &space)
  {
    std::map<dealii::types::global_dof_index, dealii::Point<2>> points;
    dealii::DoFTools::map_dofs_to_support_points(space.mapping(), space.dof_handler(), points);
    const auto &fe = space.dof_handler().get_fe();
    const auto n = static_cast<std::size_t>(space.n_dofs());
    std::vector<bool> seen(n, false);
    Nodes nodes;
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    const unsigned int n_nodes_per_cell = fe.n_dofs_per_cell() / 2;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < n_nodes_per_cell; ++i)
      {
        const auto x = dofs[fe.component_to_system_index(0, i)], y = dofs[fe.component_to_system_index(1, i)];
        if (seen[x])
          continue;
        seen[x] = true;
        nodes.dofs.push_back({{static_cast<unsigned int>(x), static_cast<unsigned int>(y)}});
        nodes.places.emplace_back(points[x][0], points[x][1]);
      }
    }
    return nodes;
  }

  Nodes free_nodes(const Space &space)
  {
    const Nodes all = all_nodes(space);
    if (!space.has_constraints())
      return all;
    Nodes nodes;
    for (std::size_t i = 0; i < all.dofs.size(); ++i)
      if (!space.is_constrained(all.dofs[i][0]))
      {
        nodes.dofs.push_back(all.dofs[i]);
        nodes.places.push_back(all.places[i]);
      }
    return nodes;
  }
} // namespace abut
