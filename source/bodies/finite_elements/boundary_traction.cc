// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/bodies/finite_elements/boundary_traction.h>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// -f_j . n_j / int phi_j for the nodes of a side.
    Eigen::VectorXd nodal_pressures(const Trace &side, const Eigen::VectorXd &forces)
    {
      const GaussRule rule(side.basis().degree() + 3);
      Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Index>(side.n_nodes()));
      for (const Segment &segment : side.segments())
        for (Index q = 0; q < rule.points.size(); ++q)
        {
          const double length = rule.weights[q] * side.tangent(segment, rule.points[q]).norm();
          const Eigen::VectorXd values = side.basis().values(rule.points[q]);
          for (std::size_t i = 0; i < segment.nodes.size(); ++i)
            weights[segment.nodes[i]] += length * values[static_cast<Index>(i)];
        }
      Eigen::VectorXd pressures(weights.size());
      for (std::size_t node = 0; node < side.n_nodes(); ++node)
      {
        const auto i = static_cast<Index>(node);
        pressures[i] = -side.node_normals()[node].dot(forces.segment<2>(2 * i)) / weights[i];
      }
      return pressures;
    }
  } // namespace

  BoundaryTraction::BoundaryTraction(const FiniteElementBody &body, const Eigen::VectorXd &contact_forces)
      : conditions_(body), glue_(body.space())
  {
    for (std::size_t k = 0; k < body.contact_sides().size(); ++k)
    {
      const Trace &side = body.contact_sides()[k];
      const auto n = static_cast<Index>(side.n_nodes());
      const Eigen::VectorXd pressures =
          nodal_pressures(side, contact_forces.segment(body.trace_offset(k), 2 * n));
      Eigen::VectorXd field = Eigen::VectorXd::Zero(body.space().n_dofs());
      for (std::size_t node = 0; node < side.n_nodes(); ++node)
        field[side.node_dofs()[node][0]] = pressures[static_cast<Index>(node)];
      pressures_[body.contact_boundary(k)] = field;
    }
  }

  KnownTraction BoundaryTraction::at(const dealii::FEFaceValues<2> &values, const unsigned int point,
                                     const dealii::types::boundary_id boundary,
                                     const std::vector<dealii::types::global_dof_index> &dofs) const
  {
    const auto place = values.quadrature_point(point);
    const auto outward = values.normal_vector(point);
    const Vector2 x(place[0], place[1]), normal(outward[0], outward[1]);
    KnownTraction traction;
    if (glue_.is_glued(boundary) && glue_.opposite(boundary, x))
      return traction;
    traction.value = conditions_.traction(boundary, x, normal);
    if (const auto found = pressures_.find(boundary); found != pressures_.end())
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (values.get_fe().system_to_component_index(i).first == 0)
          traction.value -=
              found->second[static_cast<Index>(dofs[i])] * values.shape_value(i, point) * normal;
    traction.directions = free_directions(conditions_.supported(boundary, normal));
    return traction;
  }
} // namespace abut
