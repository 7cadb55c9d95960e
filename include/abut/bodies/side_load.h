// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/condition.h>
#include <abut/scene/placement.h>
#include <abut/trace/trace.h>

#include <functional>

namespace abut
{
  /// The traction (world frame) that a condition prescribes at a point of a side with outward unit normal n.
  Vector2 prescribed_traction(const Condition &condition, const Placement &placement, const Vector2 &point,
                              const Vector2 &normal);

  /// A traction (world frame) at a point of a side with outward unit normal n.
  using SideTraction = std::function<Vector2(const Vector2 &point, const Vector2 &normal)>;

  /// int t phi_j over a segment, a row for every node; also where the traction grows like an inverse square
  /// root at a vertex of the mesh, jumps or is narrow.
  Eigen::MatrixX2d traction_moments(const Trace &side, const Segment &segment, const SideTraction &traction);

  /// Adds int t . v over a side, (12), for a condition of kind traction or pressure.
  void add_traction(const Trace &side, const Condition &condition, const Placement &placement,
                    Eigen::VectorXd &load);
} // namespace abut
