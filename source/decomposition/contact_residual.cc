// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_residual.h>
#include <abut/decomposition/measures.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Sum over a part and up to `reach` neighbours on both sides in its stretch.
    double sum_around(const Stretch &stretch, const std::size_t k, const Eigen::VectorXd &values)
    {
      constexpr std::size_t reach = 2;
      const std::size_t first = std::max(stretch.first + reach, k) - reach,
                        last = std::min(k + reach + 1, stretch.last);
      return values.segment(static_cast<Index>(first), static_cast<Index>(last - first)).sum();
    }
  } // namespace

  Eigen::VectorXd part_softness(const InterfaceProblem &problem)
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(problem.n_pressures());
    problem.for_each_pair([&](const ContactPair &pair, const std::size_t surface) {
      for (Index component = 0; component < problem.layout().n_components(); ++component)
        result(problem.layout().indices(surface, component)) +=
            (1. / pair.slave().young_modulus + 1. / pair.master().young_modulus) * pair.weights();
    });
    return result;
  }

  ContactResidual::ContactResidual(const InterfaceProblem &problem, const InterfaceCompliance &compliance)
      : problem_(problem), compliance_(compliance), beta_(part_softness(problem))
  {
    const Eigen::VectorXd alternating = Eigen::VectorXd::NullaryExpr(
        problem.n_pressures(), [](const Index k) { return k % 2 == 0 ? 1. : -1.; });
    const Eigen::VectorXd work =
        compliance.apply(alternating).head(alternating.size()).cwiseProduct(alternating);
    const Eigen::VectorXd squares = problem.weights().cwiseAbs2();
    for (std::size_t surface = 0; surface < problem.surfaces().size(); ++surface)
    {
      const Eigen::VectorXd own_work = problem.of_surface(surface, work),
                            own_squares = problem.of_surface(surface, squares);
      for (const Stretch &stretch : problem.surfaces()[surface].partition().stretches())
        for (std::size_t k = stretch.first; k < stretch.last; ++k)
        {
          const double softness = sum_around(stretch, k, own_work) / sum_around(stretch, k, own_squares);
          const Index multiplier = problem.layout().index(surface, k, normal_direction);
          if (softness > 0.) // not where all is held
            beta_[multiplier] = std::min(beta_[multiplier], softness * problem.weights()[multiplier]);
        }
    }
  }

  double ContactResidual::guaranteed(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                                     const Eigen::VectorXd &pressure_response,
                                     const Eigen::VectorXd &response) const
  {
    AssertDimension(pressures.size(), problem_.n_pressures());
    AssertDimension(pressure_response.size(), problem_.response_size());
    return relative(residual(pressures, response, Eigen::VectorXd::Zero(pressures.size())), loads, pressures,
                    pressure_response);
  }

  double ContactResidual::algebraic(const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                                    const Eigen::VectorXd &pressure_response,
                                    const Eigen::VectorXd &response) const
  {
    AssertDimension(pressures.size(), problem_.n_pressures());
    AssertDimension(pressure_response.size(), problem_.response_size());
    const Eigen::VectorXd left = residual(pressures, response, beta_);
    // Bodies that touch without force: there is nothing to compare round-off with but the gaps everywhere.
    constexpr double round_off = 1e-12;
    const Index n = pressures.size();
    const Eigen::ArrayXd terms = loads.response.head(n).array().abs() +
                                 pressure_response.head(n).array().abs() +
                                 (response - loads.response - pressure_response).head(n).array().abs(),
                         gaps = left.array().abs() * (problem_.penalties() + beta_).array();
    if (!left.isZero(0.) && (gaps <= round_off * (terms / problem_.weights().array()).maxCoeff()).all() &&
        (pressure_response.head(n).array().abs() <= round_off * terms).all())
      return std::numeric_limits<double>::epsilon();
    return relative(left, loads, pressures, pressure_response);
  }

  Eigen::VectorXd ContactResidual::residual(const Eigen::VectorXd &pressures, const Eigen::VectorXd &response,
                                            const Eigen::VectorXd &beta) const
  {
    return problem_.law().residual(pressures, problem_.gaps(response), problem_.penalties(), beta);
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
