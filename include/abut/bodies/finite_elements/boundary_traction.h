// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/glue_partners.h>
#include <abut/bodies/finite_elements/side_conditions.h>

#include <deal.II/fe/fe_values.h>

namespace abut
{
  /// What the data of a problem say of the traction sigma . n at a boundary point.
  struct KnownTraction
  {
    Vector2 value = Vector2::Zero(); ///< force per area, world frame
    /// Unit directions d, at right angles, along which `value.dot(d)` is the traction. Along the others a
    /// support carries what it must.
    std::vector<Vector2> directions;
  };

  /**
   * The traction on a body's boundary as far as it is known without its solution: prescribed tractions, the
   * contact pressure, zero on free sides and along rollers. Nothing is known of it where sides are glued.
   *
   * The contact pressure is read off the consistent nodal forces on a contact side: at node j it is -f_j .
   * n_j / int phi_j, and between nodes what the shape functions make of these values.
   */
  class BoundaryTraction
  {
  public:
    /// `contact_forces`: a trace vector. The body must outlive the object.
    BoundaryTraction(const FiniteElementBody &body, const Eigen::VectorXd &contact_forces);

    /// At a quadrature point of a boundary face; `values` have to show points, normals and shape values.
    KnownTraction at(const dealii::FEFaceValues<2> &values, unsigned int point,
                     dealii::types::boundary_id boundary,
                     const std::vector<dealii::types::global_dof_index> &dofs) const;

  private:
    SideConditions conditions_;
    GluePartners glue_;
    /// Nodal pressures of the contact sides, in the first component of fields that vanish elsewhere.
    std::map<dealii::types::boundary_id, Eigen::VectorXd> pressures_;
  };
} // namespace abut
