// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace abut
{
  struct NonnegativeFit
  {
    Eigen::VectorXd x;
    bool optimal = true; ///< false: the steps ran out, |A x - b| may become smaller still
  };

  /// x >= 0 that makes |A x - b| smallest: the active-set method of [LawsonHanson1974], chapter 23.
  NonnegativeFit nonnegative_fit(const Eigen::MatrixXd &matrix, const Eigen::VectorXd &right_side);
} // namespace abut
