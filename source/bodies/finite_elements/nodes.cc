// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/nodes.h>

#include <deal.II/fe/fe_values.h>

namespace abut
{
  namespace
  {
    /// Of all processes; as plain numbers, of which there are many.
    Nodes everybodys(const Space &space, const Nodes &own)
    {
      std::vector<unsigned int> dofs;
      std::vector<double> coordinates;
      for (const auto &of_node : own.dofs)
        dofs.insert(dofs.end(), of_node.begin(), of_node.end());
      for (const Vector2 &place : own.places)
        coordinates.insert(coordinates.end(), place.begin(), place.end());
      dofs = space.gathered(std::move(dofs));
      coordinates = space.gathered(std::move(coordinates));
      Nodes all;
      for (std::size_t i = 0; i < dofs.size(); i += 2)
      {
        all.dofs.push_back({{dofs[i], dofs[i + 1]}});
        all.places.emplace_back(coordinates[i], coordinates[i + 1]);
      }
      return all;
    }
  } // namespace

  Nodes all_nodes(const Space &space)
  {
    const auto &fe = space.dof_handler().get_fe();
    // Both components have their nodes in the same places.
    const dealii::Quadrature<2> places(fe.base_element(0).get_unit_support_points());
    dealii::FEValues<2> values(space.mapping(), fe.base_element(0), places, dealii::update_quadrature_points);
    std::vector<bool> seen(static_cast<std::size_t>(space.n_dofs()), false);
    Nodes nodes;
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const Cell &cell : space.own_cells())
    {
      cell->get_dof_indices(dofs);
      values.reinit(static_cast<dealii::Triangulation<2>::cell_iterator>(cell));
      for (unsigned int i = 0; i < places.size(); ++i)
      {
        const auto x = dofs[fe.component_to_system_index(0, i)], y = dofs[fe.component_to_system_index(1, i)];
        if (seen[x] || !space.is_own(x))
          continue;
        seen[x] = true;
        nodes.dofs.push_back({{static_cast<unsigned int>(x), static_cast<unsigned int>(y)}});
        nodes.places.emplace_back(values.quadrature_point(i)[0], values.quadrature_point(i)[1]);
      }
    }
    return space.mesh().processes ? everybodys(space, nodes) : nodes;
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
