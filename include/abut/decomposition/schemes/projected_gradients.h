// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace abut
{
  /// min x . Q x / 2 + b . x over x >= 0 with a symmetric positive definite Q.
  struct BoundedProblem
  {
    std::function<Eigen::VectorXd(const Eigen::VectorXd &)> product; ///< Q x
    Eigen::VectorXd linear;                                          ///< b
    double norm; ///< at least half of the largest eigenvalue
  };

  /**
   * Modified proportioning with reduced gradient projections: conjugate gradients on the free unknowns,
   * which are left by a projected gradient step where they meet the bound, or by a step along the bound's own
   * gradient where that is the larger one [Dostal2005]. The rate depends on the condition of Q alone.
   */
  class ProjectedGradients
  {
  public:
    explicit ProjectedGradients(const BoundedProblem &problem) : problem_(problem) {}

    /// Improves x until the projected gradient is at most `tolerance`; returns whether it is, after at most
    /// `most_products`. `n_products` counts on; `observer` is told of every iterate. Throws
    /// ComputationError where Q turns out not to be positive definite, or no matrix of numbers.
    bool solve(double tolerance, unsigned int most_products, unsigned int &n_products, Eigen::VectorXd &x,
               const std::function<void(const Eigen::VectorXd &)> &observer) const;

  private:
    const BoundedProblem &problem_;
  };

  /// The largest eigenvalue by a few steps of the power method: a lower estimate, good to some per cent.
  double rough_norm(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &product, Eigen::Index n);
} // namespace abut
