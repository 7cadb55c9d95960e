// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/bodies/finite_elements/floating.h>

#include <Eigen/QR>

namespace abut
{
  namespace
  {
    /// A mode at all unknowns of the nodes.
    Eigen::VectorXd mode_field(const Nodes &nodes, const RigidMode &mode, const Eigen::Index n_dofs)
    {
      Eigen::VectorXd field = Eigen::VectorXd::Zero(n_dofs);
      for (std::size_t i = 0; i < nodes.dofs.size(); ++i)
      {
        const Vector2 u = mode.displacement(nodes.places[i]);
        field[nodes.dofs[i][0]] = u.x();
        field[nodes.dofs[i][1]] = u.y();
      }
      return field;
    }
  } // namespace

  FloatingModes::FloatingModes(const Nodes &nodes, const std::vector<RigidMode> &modes,
                               const Eigen::SparseMatrix<double> &directions)
      : reduced_(directions.cols(), static_cast<Eigen::Index>(modes.size()))
  {
    for (std::size_t k = 0; k < modes.size(); ++k)
      reduced_.col(static_cast<Eigen::Index>(k)) =
          directions.transpose() * mode_field(nodes, modes[k], directions.rows());
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(reduced_);
    orthonormal_ = qr.householderQ() * Eigen::MatrixXd::Identity(reduced_.rows(), reduced_.cols());
    // The unknowns on which the motions differ most.
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> choice(orthonormal_.transpose());
    for (Eigen::Index k = 0; k < size(); ++k)
      sprung_.push_back(choice.colsPermutation().indices()[k]);
  }

  void FloatingModes::check(const Eigen::MatrixXd &stiffness_times_orthonormal, const double largest,
                            const std::string &name) const
  {
    constexpr double not_free = 1e-8;
    if (stiffness_times_orthonormal.cwiseAbs().maxCoeff() > not_free * largest)
      throw UserError(name + ": the supports hold the body against a rigid motion by their curvature alone, "
                             "almost free; give it supports that hold it or leave the motion free");
  }

  Eigen::MatrixXd FloatingModes::balanced(const Eigen::MatrixXd &columns) const
  {
    return columns - orthonormal_ * (orthonormal_.transpose() * columns);
  }
} // namespace abut
