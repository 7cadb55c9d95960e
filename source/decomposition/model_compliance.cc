// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/pressure_operator.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    const double pi = std::acos(-1.);

    /// The kernel (f/pi) log(1 + (c/r)^2) of one pair, f the sum of 1/E.
    struct ModelKernel
    {
      double factor, depth;

      explicit ModelKernel(const ContactPair &pair)
          : factor(0.), depth(.5 * std::max(pair.slave().depth, pair.master().depth))
      {
        for (const ContactBody &side : {pair.slave(), pair.master()})
          factor += side.flexibility / (pi * side.depth);
      }

      double at(const double distance) const
      {
        const double ratio = depth / distance;
        return factor * std::log1p(ratio * ratio);
      }
      /// Mean over the pairs of points of an interval.
      double own(const double width) const
      {
        return factor * std::max(3. + 2. * std::log(depth / width), 1.);
      }
    };
  } // namespace

  Eigen::MatrixXd model_compliance(const InterfaceProblem &problem, const ActiveSet &active)
  {
    const auto n = static_cast<Index>(active.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (Index j = 0; j < n; ++j)
    {
      const Index column = active[static_cast<std::size_t>(j)];
      const std::size_t pair = problem.pair_of(column);
      const ModelKernel kernel(problem.pairs()[pair]);
      const Vector2 &here = problem.place(column);
      const double weight = problem.weights()[column];
      matrix(j, j) = weight * weight * kernel.own(weight);
      for (Index i = j + 1; i < n; ++i)
      {
        const Index row = active[static_cast<std::size_t>(i)];
        if (problem.pair_of(row) == pair)
          matrix(i, j) = matrix(j, i) =
              weight * problem.weights()[row] * kernel.at((problem.place(row) - here).norm());
      }
    }
    return matrix;
  }
} // namespace abut
