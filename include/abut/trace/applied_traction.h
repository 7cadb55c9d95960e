// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

namespace abut
{
  /// int phi_i phi_j over a segment.
  Eigen::MatrixXd segment_mass(const Trace &side, const Segment &segment);

  /**
   * The traction that nodal forces on a side stand for: the continuous t = sum_j t_j phi_j of the trace with
   * int t . phi_i = f_i. Finite elements cannot tell it from any other traction with these forces, e.g. from
   * that of the piecewise constant multipliers, which jumps; for boundary elements and exact responses it
   * is the smooth one. Trace vectors: forces per thickness, tractions as force per area.
   */
  Eigen::VectorXd applied_traction(const Trace &side, const Eigen::VectorXd &forces);
} // namespace abut
