// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

namespace abut
{
  /// The body force of a description at a point of the plane: force per volume, world frame.
  Vector2 body_force(const BodyDescription &body, const Vector2 &point);

  /// Adds the body force of the description to a load vector. A formula is looked at wherever it differs on
  /// more than two thousandths of the body's extent.
  void add_body_force(const Space &space, const BodyDescription &body, Eigen::VectorXd &load);

  /// int |f - P f|^2 over every active cell, P the projection on polynomials a degree below the space's; with
  /// that many points too. Empty for a force that is the same everywhere.
  Eigen::VectorXd body_force_oscillation(const Space &space, const BodyDescription &body);
} // namespace abut
