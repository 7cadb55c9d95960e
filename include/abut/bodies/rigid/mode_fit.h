// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/rigid_modes.h>

#include <Eigen/QR>

#include <array>

namespace abut
{
  double farthest_from(const Vector2 &centre, const Nodes &nodes);
  /// The displacements of the nodes in a rigid motion.
  Eigen::VectorXd field_of(const RigidMode &mode, const Nodes &nodes);

  /// The three rigid motions of a body beside the displacement components that its supports prescribe.
  class ModeFit
  {
  public:
    /// `weights` of the components, above 0: the length of the side that each stands for.
    ModeFit(const Nodes &nodes, const std::vector<PrescribedComponent> &components,
            const Eigen::VectorXd &weights);

    /// The smallest rigid motion with these values of the components, at the nodes. Throws UserError,
    /// beginning with `body`, where there is none.
    Eigen::VectorXd motion(const Eigen::VectorXd &values, const std::string &body) const;
    /// The forces along the components that balance forces at the nodes, as far as they can: those with the
    /// smallest sum of squares by weights, as of uniform tractions where these do.
    Eigen::VectorXd balancing(const Eigen::VectorXd &nodal_forces) const;

  private:
    std::vector<PrescribedComponent> components_;
    Eigen::VectorXd weights_;
    Eigen::MatrixX3d fields_; ///< of the motions, at the nodes
    Eigen::MatrixX3d rows_;   ///< their components
  };
} // namespace abut
