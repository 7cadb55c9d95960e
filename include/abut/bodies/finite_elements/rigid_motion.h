// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/supports.h>

namespace abut
{
  /**
   * Splits what the supports prescribe into a rigid motion of the whole body and a rest: u = rigid + T v +
   * fixed. The rigid motion makes no stress, but in a stiff body that is carried along by far more than it
   * deforms it would take the digits of the stress away. It is the one next to the prescribed values in the
   * sense of least squares.
   */
  struct RigidMotions
  {
    Eigen::VectorXd fixed;  ///< of Supports::fixed, all unknowns
    Eigen::VectorXd moving; ///< of Supports::moving
  };

  /// Takes the rigid motions out of `supports.fixed` and `supports.moving`; zero where the supports leave a
  /// motion free.
  RigidMotions split_off_rigid_motions(const Nodes &nodes, Supports &supports);
} // namespace abut
