// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/schemes/projected_gradients.h>
#include <abut/decomposition/spectrum.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    /// The gradient on the free unknowns.
    Eigen::VectorXd free_gradient(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient)
    {
      return (x.array() > 0.).select(gradient, 0.);
    }
    /// That part of the gradient at the bound which leads away from it.
    Eigen::VectorXd bound_gradient(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient)
    {
      return (x.array() > 0.).select(0., gradient.cwiseMin(0.));
    }

    /// The longest step along -direction that stays within the bound.
    double feasible_step(const Eigen::VectorXd &x, const Eigen::VectorXd &direction)
    {
      double step = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < x.size(); ++i)
        if (direction[i] > 0.)
          step = std::min(step, x[i] / direction[i]);
      return step;
    }

    /// v . Q v of a direction and its image.
    double positive_curvature(const Eigen::VectorXd &direction, const Eigen::VectorXd &image)
    {
      const double curvature = direction.dot(image);
      if (!(curvature > 0.) || !std::isfinite(curvature))
        throw ComputationError(
            "The scheme conjugate has met pressures that deform no body, or no numbers: the interface "
            "compliance is not positive definite; let the contact sides end before held nodes, or give the "
            "contacts a small Penalty coefficient");
      return curvature;
    }
  } // namespace

  bool ProjectedGradients::solve(const double tolerance, const unsigned int most_products,
                                 unsigned int &n_products, Eigen::VectorXd &x,
                                 const std::function<void(const Eigen::VectorXd &)> &observer) const
  {
    AssertDimension(x.size(), problem_.linear.size());
    Assert(!(x.array() < 0.).any(), dealii::ExcMessage("the way begins within the bound"));
    Assert(!(problem_.norm <= 0.), dealii::ExcMessage("the largest eigenvalue is positive"));
    const double fixed_step = 1. / problem_.norm;
    const auto product = [&](const Eigen::VectorXd &v) {
      ++n_products;
      return problem_.product(v);
    };
    Eigen::VectorXd gradient = product(x) + problem_.linear;
    Eigen::VectorXd direction = free_gradient(x, gradient);
    for (;;)
    {
      const Eigen::VectorXd inner = free_gradient(x, gradient), outer = bound_gradient(x, gradient);
      if ((inner + outer).norm() <= tolerance)
        return true;
      if (n_products >= most_products)
        return false;
      const Eigen::VectorXd reduced = inner.cwiseMin(x / fixed_step);
      if (outer.squaredNorm() > reduced.dot(inner)) // proportioning
      {
        const Eigen::VectorXd image = product(outer);
        const double step = gradient.dot(outer) / positive_curvature(outer, image);
        x -= step * outer;
        gradient -= step * image;
        direction = free_gradient(x, gradient);
      }
      else
      {
        const Eigen::VectorXd image = product(direction);
        const double curvature = positive_curvature(direction, image), longest = feasible_step(x, direction);
        const double step = gradient.dot(direction) / curvature;
        if (step <= longest) // conjugate gradients
        {
          x = (x - step * direction).cwiseMax(0.);
          gradient -= step * image;
          const Eigen::VectorXd next = free_gradient(x, gradient);
          direction = next - next.dot(image) / curvature * direction;
        }
        else // expansion
        {
          x -= longest * direction;
          gradient -= longest * image;
          x = (x - fixed_step * free_gradient(x, gradient)).cwiseMax(0.);
          gradient = product(x) + problem_.linear;
          direction = free_gradient(x, gradient);
        }
      }
      if (observer)
        observer(x);
    }
  }

  double rough_norm(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &product,
                    const Eigen::Index n)
  {
    constexpr int steps = 12;
    Eigen::VectorXd v = probing_vector(n);
    double norm = 0.;
    for (int i = 0; i < steps; ++i)
    {
      v = product(v.normalized());
      norm = v.norm();
      if (!(norm > 0.))
        return 1.;
    }
    return norm;
  }
} // namespace abut
