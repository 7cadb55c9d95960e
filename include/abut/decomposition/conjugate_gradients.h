// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace abut
{
  /// What conjugate gradients have found.
  struct GradientSolution
  {
    enum class End
    {
      converged,
      not_definite, ///< a direction without curvature, or no numbers
      abandoned,
      too_many
    };
    End end = End::too_many;
    Eigen::VectorXd x;
  };

  using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;

  /**
   * Solves `product`(x) = b by conjugate gradients with a preconditioner, until the residual has fallen to
   * `accuracy` times that of x = 0, in the norm of the preconditioner. Both maps are symmetric and positive
   * definite. `abandon`, if any, is asked after every product.
   */
  GradientSolution conjugate_gradients(const LinearMap &product, const LinearMap &precondition,
                                       const Eigen::VectorXd &right_side, double accuracy,
                                       int most_iterations, const std::function<bool()> &abandon = {});
} // namespace abut
