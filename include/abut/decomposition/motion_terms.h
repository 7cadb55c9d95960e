// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_motions.h>

namespace abut
{
  /// The motions that are unknowns of an interface problem, those that contact holds, without the others.
  struct MotionTerms
  {
    InterfaceMotions all;
    std::vector<Eigen::Index> held;         ///< which of all
    std::vector<std::string> dropped_loads; ///< on motions that are not held, see held_motions
    Eigen::MatrixXd gaps;                   ///< G
    Eigen::MatrixXd stiffness;              ///< H
    Eigen::VectorXd loads;                  ///< e
    /// D_k of the parts that press on the body of each motion, a row each: the forces that a motion may feel.
    Eigen::MatrixXd reach;
    /// G^T ((k_1 + k_2 + theta) D)^-1 G, its diagonal: how stiff elastic layers would hold each motion.
    Eigen::VectorXd layer_stiffness;

    Eigen::Index size() const { return loads.size(); }
    /// All amplitudes, those that are not held zero.
    Eigen::VectorXd amplitudes(const Eigen::VectorXd &of_held) const;
    /// H alpha - e - G^T p: zero in balance.
    Eigen::VectorXd unbalanced(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes) const
    {
      return stiffness * amplitudes - loads - gaps.transpose() * pressures;
    }
    /// The largest unbalanced force; 0 without motions.
    double imbalance(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes) const
    {
      return size() > 0 ? unbalanced(pressures, amplitudes).cwiseAbs().maxCoeff() : 0.;
    }
    /// The size of the forces that have to balance.
    double force_scale(const Eigen::VectorXd &pressures) const;
    /// Whether all balance to 1e-10 of the forces and the round-off of the motions in elastic layers.
    bool is_balanced(const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes) const;
  };

  /// Throws UserError where contact cannot hold what the loads push (see held_motions).
  MotionTerms make_motion_terms(const InterfaceProblem &problem);
} // namespace abut
