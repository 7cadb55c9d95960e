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

  /// Into how many pieces a segment has to be cut for a formula on its side to be seen wherever it differs on
  /// more than a thousandth of the side: there are 128 on the side at least.
  unsigned int n_sampled_pieces(const Trace &side, const Segment &segment);

  /// int t phi_j over a segment, a row for every node; also where the traction grows like an inverse square
  /// root at a vertex of the mesh, jumps or is narrow. `n_pieces`: where it is looked at, at first.
  Eigen::MatrixX2d traction_moments(const Trace &side, const Segment &segment, const SideTraction &traction,
                                    unsigned int n_pieces);

  /// Adds int t . v over a side, (12), for a condition of kind traction or pressure.
  void add_traction(const Trace &side, const Condition &condition, const Placement &placement,
                    Eigen::VectorXd &load);
} // namespace abut
