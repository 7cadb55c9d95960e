// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/nodes.h>

#include <deal.II/fe/fe_values.h>

namespace abut
{
  Nodes all_nodes(const Space &space)
  {
    const auto &fe = space.dof_handler().get_fe();
    // Both components have their nodes in the same places.
    const dealii::Quadrature<2> places(fe.base_element(0).get_unit_support_points());
    dealii::FEValues<2> values(space.mapping(), fe.base_element(0), places, dealii::update_quadrature_points);
    std::vector<bool> seen(static_cast<std::size_t>(space.n_dofs()), false);
    Nodes nodes;
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      values.reinit(static_cast<dealii::Triangulation<2>::cell_iterator>(cell));
      for (unsigned int i = 0; i < places.size(); ++i)
      {
        const auto x = dofs[fe.component_to_system_index(0, i)], y = dofs[fe.component_to_system_index(1, i)];
        if (seen[x])
          continue;
        seen[x] = true;
        nodes.dofs.push_back({{static_cast<unsigned int>(x), static_cast<unsigned int>(y)}});
        nodes.places.emplace_back(values.quadrature_point(i)[0], values.quadrature_point(i)[1]);
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
