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

    /// The multipliers of a pair with a weight, along the slave side.
    std::vector<Index> along_side(const InterfaceProblem &problem, const std::size_t pair)
    {
      const ContactBody &slave = problem.pairs()[pair].slave();
      const std::vector<double> &places =
          problem.bodies()[slave.body]->contact_sides()[slave.side].node_arc_lengths();
      const Index first = problem.pressure_offset(pair);
      std::vector<Index> order;
      for (Index k = 0; k < problem.pairs()[pair].n_multipliers(); ++k)
        if (problem.weights()[first + k] > 0.)
          order.push_back(first + k);
      const auto place = [&](const Index i) { return places[static_cast<std::size_t>(i - first)]; };
      std::sort(order.begin(), order.end(),
                [&](const Index i, const Index j) { return place(i) < place(j); });
      return order;
    }

    /// Sum over up to `reach` neighbours on both sides.
    double sum_around(const std::vector<Index> &order, const std::size_t k, const Eigen::VectorXd &values)
    {
      constexpr std::size_t reach = 2;
      double sum = 0.;
      for (std::size_t j = k - std::min(k, reach); j < std::min(k + reach + 1, order.size()); ++j)
        sum += values[order[j]];
      return sum;
    }
  } // namespace

  Eigen::VectorXd node_softness(const InterfaceProblem &problem)
  {
    Eigen::VectorXd result = problem.weights();
    for (std::size_t i = 0; i < problem.pairs().size(); ++i)
    {
      const ContactPair &pair = problem.pairs()[i];
      result.segment(problem.pressure_offset(i), pair.n_multipliers()) *=
          1. / pair.slave().young_modulus() + 1. / pair.master().young_modulus();
    }
    return result;
  }

  ContactResidual::ContactResidual(const InterfaceProblem &problem, const InterfaceCompliance &compliance)
      : problem_(problem), compliance_(compliance), beta_(node_softness(problem))
  {
    std::vector<std::vector<Index>> orders;
    Eigen::VectorXd alternating = Eigen::VectorXd::Zero(problem.n_pressures());
    for (std::size_t pair = 0; pair < problem.pairs().size(); ++pair)
    {
      orders.push_back(along_side(problem, pair));
      for (std::size_t k = 0; k < orders.back().size(); ++k)
        alternating[orders.back()[k]] = k % 2 == 0 ? 1. : -1.;
    }
    const Eigen::VectorXd work =
        compliance.apply(alternating).head(alternating.size()).cwiseProduct(alternating);
    const Eigen::VectorXd squares = problem.weights().cwiseAbs2();
    for (const std::vector<Index> &order : orders)
      for (std::size_t k = 0; k < order.size(); ++k)
      {
        const double softness = sum_around(order, k, work) / sum_around(order, k, squares);
        if (softness > 0.) // not where all is held
          beta_[order[k]] = std::min(beta_[order[k]], softness * problem.weights()[order[k]]);
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
    const Eigen::VectorXd left = residual(pressures, problem_.gaps(response), beta_);
    // Bodies that touch without force: there is nothing to compare round-off with.
    const Index n = pressures.size();
    const Eigen::VectorXd terms = loads.response.head(n).cwiseAbs() + pressure_response.head(n).cwiseAbs() +
                                  (response - loads.response - pressure_response).head(n).cwiseAbs();
    const Eigen::ArrayXd lengths =
        left.array().abs() * (problem_.penalties() + beta_).array() * problem_.weights().array();
    if (!left.isZero(0.) && (lengths <= 1e-14 * terms.array()).all() &&
        (pressure_response.head(n).array().abs() <= 1e-12 * terms.array()).all())
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
