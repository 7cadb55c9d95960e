// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/rigid_motion.h>

#include <Eigen/QR>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Translations and the rotation about the first node, columns of length about one.
    Eigen::MatrixXd rigid_modes(const Nodes &nodes, const Index n_dofs)
    {
      Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(n_dofs, 3);
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      {
        const Vector2 arm = nodes.places[i] - nodes.places.front();
        modes(nodes.dofs[i][0], 0) = 1.;
        modes(nodes.dofs[i][1], 1) = 1.;
        modes(nodes.dofs[i][0], 2) = -arm.y();
        modes(nodes.dofs[i][1], 2) = arm.x();
      }
      for (Index k = 0; k < 3; ++k)
        modes.col(k).normalize();
      return modes;
    }
  } // namespace

  RigidMotions split_off_rigid_motions(const Nodes &nodes, Supports &supports)
  {
    const auto &t = supports.free_directions;
    const Eigen::MatrixXd modes = rigid_modes(nodes, t.rows());
    const Eigen::MatrixXd free_part = t.transpose() * modes;
    const Eigen::MatrixXd supported = modes - t * free_part; // along the supported directions alone
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(supported);
    RigidMotions motions{Eigen::VectorXd::Zero(t.rows()), Eigen::VectorXd::Zero(t.rows())};
    if (fit.rank() < 3)
      return motions;
    const auto split = [&](Eigen::VectorXd &prescribed) -> Eigen::VectorXd {
      const Eigen::VectorXd amounts = fit.solve(prescribed);
      // What the fit leaves of a motion that is rigid is round-off: it must not look like a stress.
      const double round_off = 1e-13 * prescribed.lpNorm<Eigen::Infinity>();
      prescribed -= supported * amounts;
      prescribed = (prescribed.array().abs() > round_off).select(prescribed, 0.).eval();
      return modes * amounts;
    };
    motions.fixed = split(supports.fixed);
    motions.moving = split(supports.moving);
    return motions;
  }
} // namespace abut
