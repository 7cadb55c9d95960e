// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/compliance.h>
#include <abut/decomposition/pressure_operator.h>

#include <Eigen/SparseCore>

namespace abut
{
  /// The sum of blocks of Z on an active set: its lower triangle, with all of its diagonal. The columns of a
  /// block have to be in increasing order.
  Eigen::SparseMatrix<double> sum_on(const ActiveSet &active, const std::vector<ComplianceBlock> &blocks);
} // namespace abut
