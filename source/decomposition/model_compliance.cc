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

    /// The kernel 2/(pi E) K_0(kappa r) of one pair, summed over its bodies.
    struct ModelKernel
    {
      double factor, kappa;

      explicit ModelKernel(const ContactPair &pair)
          : factor(0.), kappa(2. / std::max(pair.slave().depth, pair.master().depth))
      {
        for (const ContactBody &side : {pair.slave(), pair.master()})
          factor += 2. / pi * side.flexibility / side.depth;
      }

      double at(const double distance) const
      {
        const double argument = kappa * distance;
        return argument < 500. ? factor * std::cyl_bessel_k(0., argument) : 0.;
      }
      /// Mean over the pairs of points of an interval, of the logarithm that K_0 begins with.
      double own(const double width) const
      {
        constexpr double euler = .57721566490153286;
        return factor * std::max(1.5 - euler - std::log(.5 * kappa * width), .5);
      }
    };

    std::size_t pair_of(const InterfaceProblem &problem, const Index multiplier)
    {
      std::size_t pair = problem.pairs().size() - 1;
      while (problem.pressure_offset(pair) > multiplier)
        --pair;
      return pair;
    }

    const Vector2 &place(const InterfaceProblem &problem, const std::size_t pair, const Index multiplier)
    {
      const ContactBody &slave = problem.pairs()[pair].slave();
      const Trace &trace = problem.bodies()[slave.body]->contact_sides()[slave.side];
      return trace.node_points()[static_cast<std::size_t>(multiplier - problem.pressure_offset(pair))];
    }
  } // namespace

  Eigen::MatrixXd model_compliance(const InterfaceProblem &problem, const ActiveSet &active)
  {
    const auto n = static_cast<Index>(active.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (Index j = 0; j < n; ++j)
    {
      const Index column = active[static_cast<std::size_t>(j)];
      const std::size_t pair = pair_of(problem, column);
      const ModelKernel kernel(problem.pairs()[pair]);
      const Vector2 &here = place(problem, pair, column);
      const double weight = problem.weights()[column];
      matrix(j, j) = weight * weight * kernel.own(weight);
      for (Index i = j + 1; i < n; ++i)
      {
        const Index row = active[static_cast<std::size_t>(i)];
        if (pair_of(problem, row) == pair)
          matrix(i, j) = matrix(j, i) =
              weight * problem.weights()[row] * kernel.at((place(problem, pair, row) - here).norm());
      }
    }
    return matrix;
  }
} // namespace abut
