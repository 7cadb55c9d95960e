// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the assembled stiffness says of forces.

#include <abut/bodies/finite_elements/finite_element_body.h>

#include <cmath>

namespace abut
{
  Eigen::VectorXd FiniteElementBody::missing_forces(const Eigen::VectorXd &deformation,
                                                    const Eigen::VectorXd &contact_forces) const
  {
    return stiffness_->times(deformation) - load_ - trace_to_dofs_ * contact_forces;
  }

  Eigen::VectorXd FiniteElementBody::support_forces(const Eigen::VectorXd &deformation,
                                                    const Eigen::VectorXd &contact_forces) const
  {
    const Eigen::VectorXd forces = missing_forces(deformation, contact_forces);
    if (!space_->has_constraints())
      return forces;
    return space_->expansion().transpose() * forces;
  }

  std::vector<Eigen::VectorXd> FiniteElementBody::glue_forces(const Eigen::VectorXd &deformation,
                                                              const Eigen::VectorXd &contact_forces) const
  {
    // Slaves have no supports: all that is missing there, or at nodes that hang on them, comes from the glue,
    // which takes it from the others.
    std::vector<Eigen::VectorXd> forces;
    if (space_->glued_sides().empty())
      return forces;
    const Eigen::VectorXd missing =
        space_->hanging_node_expansion().transpose() * missing_forces(deformation, contact_forces);
    for (const Eigen::SparseMatrix<double> &rows : space_->glue_rows())
      forces.emplace_back(rows.transpose() * missing);
    return forces;
  }

  double FiniteElementBody::rigid_side_force(const Eigen::VectorXd &deformation,
                                             const Eigen::VectorXd &contact_forces) const
  {
    return side_motion_.dot(support_forces(deformation, contact_forces));
  }

  double FiniteElementBody::condition() const
  {
    constexpr int steps = 60; // of the power method, from a vector without a pattern
    const auto &t = supports_.free_directions;
    Eigen::VectorXd largest = Eigen::VectorXd::NullaryExpr(
        t.cols(), [](const Eigen::Index i) { return std::sin(1. + 7. * static_cast<double>(i)); });
    largest.normalize();
    Eigen::VectorXd smallest = largest;
    double largest_value = 0., smallest_inverse = 0.;
    for (int step = 0; step < steps; ++step)
    {
      largest = t.transpose() * stiffness_->times(t * largest);
      largest_value = largest.norm();
      largest /= largest_value;
      smallest = solve(smallest);
      smallest_inverse = smallest.norm();
      smallest /= smallest_inverse;
    }
    return largest_value * smallest_inverse;
  }
} // namespace abut
