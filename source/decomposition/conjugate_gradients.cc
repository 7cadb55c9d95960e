// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/conjugate_gradients.h>

#include <cmath>
#include <utility>

namespace abut
{
  GradientSolution conjugate_gradients(const LinearMap &product, const LinearMap &precondition,
                                       const Eigen::VectorXd &right_side, const double accuracy,
                                       const int most_iterations, const std::function<bool()> &abandon)
  {
    using End = GradientSolution::End;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right_side.size()), residual = right_side;
    Eigen::VectorXd z = precondition(residual), direction = z;
    double rho = residual.dot(z);
    const double enough = accuracy * accuracy * rho;
    for (int i = 0; rho > enough; ++i)
    {
      if (i == most_iterations)
        return {End::too_many, x};
      const Eigen::VectorXd image = product(direction);
      if (abandon && abandon())
        return {End::abandoned, x};
      const double curvature = direction.dot(image);
      if (!(curvature > 0.))
        return {End::not_definite, x};
      x += rho / curvature * direction;
      residual -= rho / curvature * image;
      z = precondition(residual);
      const double before = std::exchange(rho, residual.dot(z));
      direction = z + rho / before * direction;
    }
    return {std::isfinite(rho) ? End::converged : End::not_definite, x};
  }
} // namespace abut
