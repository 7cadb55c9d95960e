// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <vector>

namespace abut
{
  /**
   * The contact pressure sum_i p_i psi_i that the multipliers p_i apply to both bodies, as a polynomial on
   * each segment of the slave side: its values at the segment's nodes. psi_i is dual to the trace's shape
   * functions (see MortarCoupling; the master is taken to cover the side wholly), so that the pressure jumps
   * at vertices: on each segment it has the moments int p phi_i = p_i int phi_i.
   */
  std::vector<Eigen::VectorXd> applied_pressure(const Trace &slave, const Eigen::VectorXd &multipliers);
} // namespace abut
