// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  /**
   * A matrix without initial values, in large pages where the system has them to give: to touch small pages
   * for the first time can take several times as long as to compute what goes into them.
   */
  Eigen::MatrixXd large_matrix(Eigen::Index rows, Eigen::Index columns);

  /// Gives a symmetric matrix its upper triangle, of which the lower one is there, by tiles that stay in the
  /// cache.
  void complete_symmetric(Eigen::MatrixXd &matrix);
} // namespace abut
