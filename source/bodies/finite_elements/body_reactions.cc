// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The forces on a body and their balance.

#include <abut/bodies/balance.h>
#include <abut/bodies/finite_elements/finite_element_body.h>
#include <abut/bodies/finite_elements/nodes.h>

#include <Eigen/LU>

namespace abut
{
  namespace
  {
    /// The parts of a support's force along the directions that it holds.
    Vector2 shares(const SupportNode &node, const Vector2 &force)
    {
      if (node.directions.size() == 1)
        return {force.dot(node.directions[0]), 0.};
      Eigen::Matrix2d directions;
      directions << node.directions[0], node.directions[1];
      return directions.inverse() * force;
    }
  } // namespace

  Reactions FiniteElementBody::reactions(const Eigen::VectorXd &deformation,
                                         const Eigen::VectorXd &contact_forces) const
  {
    const Eigen::VectorXd support = support_forces(deformation, contact_forces);
    const Nodes nodes = all_nodes(*space_);
    std::vector<Vector2> places(space_->n_dofs());
    for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      places[nodes.dofs[i][0]] = nodes.places[i];
    Balance balance(nodes);
    Reactions result;
    result.applied = balance.add_all(nodes, load_);
    result.contact = balance.add_all(nodes, trace_to_dofs_ * contact_forces);
    for (const SupportNode &node : supports_.nodes)
    {
      const Vector2 along = shares(node, {support[node.dofs[0]], support[node.dofs[1]]});
      for (std::size_t i = 0; i < node.directions.size(); ++i)
      {
        const Vector2 force = along[static_cast<Eigen::Index>(i)] * node.directions[i];
        result.by_boundary.try_emplace(node.boundaries[i], Vector2::Zero()).first->second += force;
        balance.add(places[node.dofs[0]], force);
      }
    }
    result.equilibrium_residual = balance.of_forces();
    result.moment_residual = balance.of_moments();
    return result;
  }
} // namespace abut
