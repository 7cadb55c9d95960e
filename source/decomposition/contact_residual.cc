// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/neumann.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    double largest_gap(const InterfaceProblem &problem, const Eigen::VectorXd &gaps)
    {
      return gaps.size() > 0 ? (problem.weights().array() > 0.).select(gaps.array().abs(), 0.).maxCoeff()
                             : 0.;
    }
  } // namespace

  Eigen::VectorXd node_softness(const InterfaceProblem &problem)
  {
    Eigen::VectorXd result = problem.weights();
    for (std::size_t i = 0; i < problem.pairs().size(); ++i)
    {
      const ContactPair &pair = problem.pairs()[i];
      result.segment(problem.pressure_offset(i), pair.n_multipliers()) *=
          pair.slave().flexibility / pair.slave().depth + pair.master().flexibility / pair.master().depth;
    }
    return result;
  }

  ContactResidual::ContactResidual(const InterfaceProblem &problem, const InterfaceCompliance &compliance)
      : problem_(problem), compliance_(compliance), beta_(node_softness(problem))
  {
    const Index n = problem.n_pressures();
    const Eigen::VectorXd alternating = Eigen::VectorXd::NullaryExpr(n, [&](const Index i) {
      return problem.weights()[i] == 0. ? 0. : i % 2 == 0 ? 1. : -1.;
    });
    const Eigen::VectorXd work = compliance.apply(alternating).head(n).cwiseProduct(alternating);
    for (std::size_t i = 0; i < problem.pairs().size(); ++i)
    {
      const auto own = Eigen::seqN(problem.pressure_offset(i), problem.pairs()[i].n_multipliers());
      const double softness = work(own).sum() / problem.weights()(own).squaredNorm();
      if (softness > 0.) // not where all is held
        beta_(own) = softness * problem.weights()(own);
    }
  }

  double ContactResidual::guaranteed(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                                     const Eigen::VectorXd &pressure_response,
                                     const Eigen::VectorXd &response) const
  {
    return relative(residual(pressures, problem_.gaps(response), Eigen::VectorXd::Zero(pressures.size())),
                    loads, pressures, pressure_response);
  }

  double ContactResidual::algebraic(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                                    const Eigen::VectorXd &pressure_response,
                                    const Eigen::VectorXd &response) const
  {
    const Eigen::VectorXd gaps = problem_.gaps(response), left = residual(pressures, gaps, beta_);
    // Also of bodies that touch without force: there is nothing to compare with.
    const double round_off = 1e-14 * largest_gap(problem_, gaps);
    const Eigen::VectorXd lengths = left.cwiseProduct(problem_.penalties() + beta_);
    if (!left.isZero(0.) && lengths.lpNorm<Eigen::Infinity>() <= round_off)
      return std::numeric_limits<double>::epsilon();
    return relative(left, loads, pressures, pressure_response);
  }

  Eigen::VectorXd ContactResidual::residual(const Eigen::VectorXd &pressures, const Eigen::VectorXd &gaps,
                                            const Eigen::VectorXd &beta) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(pressures.size());
    for (Index i = 0; i < pressures.size(); ++i)
      if (problem_.weights()[i] > 0.)
      {
        const double theta = problem_.penalties()[i];
        result[i] =
            pressures[i] - std::max(0., pressures[i] - (gaps[i] + theta * pressures[i]) / (theta + beta[i]));
      }
    return result;
  }

  double ContactResidual::relative(const Eigen::VectorXd &residual, const InterfaceProblem::Loads &loads,
                                   const Eigen::VectorXd &pressures,
                                   const Eigen::VectorXd &pressure_response) const
  {
    if (residual.isZero(0.))
      return 0.;
    const double square = residual.dot(compliance_.apply(residual).head(residual.size()));
    const double norm = reference_norm(problem_, loads, pressures, loads.response + pressure_response);
    return norm > 0.
               ? std::max(std::sqrt(std::max(square, 0.)) / norm, std::numeric_limits<double>::epsilon())
               : std::numeric_limits<double>::infinity();
  }
} // namespace abut
