// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The motions of a body that no support prescribes.

#include <abut/bodies/finite_elements/finite_element_body.h>

namespace abut
{
  BodyMotions FiniteElementBody::motions() const
  {
    const Eigen::Index n_free = floating_.size(), n = n_free + (resultant_ ? 1 : 0);
    BodyMotions result{Eigen::MatrixXd(trace_size(), n), Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd(n),
                       free_rigid_motions_, load_.lpNorm<1>()};
    if (n_free > 0)
    {
      result.traces.leftCols(n_free) = trace_to_free_.transpose() * floating_.reduced();
      result.loads.head(n_free) =
          floating_.reduced().transpose() * (supports_.free_directions.transpose() * load_);
    }
    if (!resultant_)
      return result;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(trace_size());
    const Eigen::VectorXd at_rest = deformation(none, 0.), moved = deformation(none, 1.) - at_rest;
    result.traces.col(n_free) = trace_of(moved + rigid_motions_.moving);
    const double energy = strain_energy(moved); // of a side that carries the whole body along: round-off
    result.stiffness(n_free, n_free) = energy > 1e-10 * material().young_modulus ? 2. * energy : 0.;
    result.loads[n_free] = resultant_->force - rigid_side_force(at_rest, none);
    result.names.push_back("displacement of the rigid side " + resultant_->boundary);
    return result;
  }

  Eigen::VectorXd FiniteElementBody::free_motion(const Eigen::VectorXd &amplitudes) const
  {
    if (floating_.size() == 0)
      return Eigen::VectorXd::Zero(space_->n_dofs());
    return supports_.free_directions * (floating_.reduced() * amplitudes.head(floating_.size()));
  }

  double FiniteElementBody::rigid_side_displacement(const Eigen::VectorXd &amplitudes) const
  {
    return resultant_ ? amplitudes[floating_.size()] : 0.;
  }
} // namespace abut
