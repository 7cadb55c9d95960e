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

  Eigen::MatrixXd model_compliance(const InterfaceProblem &problem)
  {
    const Index n = problem.n_pressures();
    const Eigen::VectorXd &weights = problem.weights();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (Index j = 0; j < n; ++j)
    {
      const std::size_t pair = problem.pair_of(j);
      const ModelKernel kernel(problem.pairs()[pair]);
      const Vector2 &here = problem.place(j);
      if (weights[j] > 0.)
        matrix(j, j) = weights[j] * weights[j] * kernel.own(weights[j]);
      const Index end = problem.pressure_offset(pair) + problem.pairs()[pair].n_multipliers();
      for (Index i = j + 1; i < end; ++i)
        matrix(i, j) = matrix(j, i) = weights[j] * weights[i] * kernel.at((problem.place(i) - here).norm());
    }
    return matrix;
  }
} // namespace abut
