// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/rigid_modes.h>

#include <Eigen/SparseCore>

#include <string>
#include <vector>

namespace abut
{
  /**
   * The rigid motions R that a body's supports leave free, and the generalised inverse that they need: with
   * orthonormal Q over the free unknowns, span Q = span R, the response to a load f is P K~^-1 P f, P = I - Q
   * Q^T, where K~ is the stiffness with stiff springs at as many unknowns as there are motions. P f is in
   * balance, so that the springs stay unloaded: the response does not depend on them.
   */
  class FloatingModes
  {
  public:
    FloatingModes() = default;
    /// `modes` as of free_rigid_modes; `directions`: T of the supports at the nodes that are free to move.
    FloatingModes(const Nodes &nodes, const std::vector<RigidMode> &modes,
                  const Eigen::SparseMatrix<double> &directions);

    Eigen::Index size() const { return reduced_.cols(); }
    /// The motions as displacements along the free directions, a column each: translations by one,
    /// rotations that move the outermost node by one.
    const Eigen::MatrixXd &reduced() const { return reduced_; }
    /// Q.
    const Eigen::MatrixXd &orthonormal() const { return orthonormal_; }
    /// Throws UserError, beginning with `name`, where a motion is not quite free: K Q is not zero, beside the
    /// largest entry of K.
    void check(const Eigen::MatrixXd &stiffness_times_orthonormal, double largest,
               const std::string &name) const;
    /// Unknowns with springs in K~, each of the stiffness of the largest entry of K.
    const std::vector<Eigen::Index> &sprung() const { return sprung_; }
    /// P f for loads or displacements in columns.
    Eigen::MatrixXd balanced(const Eigen::MatrixXd &columns) const;

  private:
    Eigen::MatrixXd reduced_, orthonormal_;
    std::vector<Eigen::Index> sprung_;
  };
} // namespace abut
