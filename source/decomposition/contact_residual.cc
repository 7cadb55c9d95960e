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

  double contact_residual(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                          const InterfaceProblem::Loads &loads, const Eigen::VectorXd &pressures,
                          const Eigen::VectorXd &pressure_response, const Eigen::VectorXd &response,
                          const bool guaranteed)
  {
    const Eigen::Index n = problem.n_pressures();
    const Eigen::VectorXd gaps = problem.gaps(response), softness = node_softness(problem);
    const double round_off = 1e-14 * largest_gap(problem, gaps);
    bool is_round_off = true;
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i)
      if (problem.weights()[i] > 0.)
      {
        const double theta = problem.penalties()[i], beta = guaranteed ? 0. : softness[i];
        residual[i] =
            pressures[i] - std::max(0., pressures[i] - (gaps[i] + theta * pressures[i]) / (theta + beta));
        is_round_off = is_round_off && std::abs(residual[i]) * (theta + beta) <= round_off;
      }
    if (residual.isZero(0.))
      return 0.;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    if (is_round_off && !guaranteed) // also of bodies that touch without force: nothing to compare with
      return epsilon;
    const double square = residual.dot(compliance.apply(residual).head(n));
    const double norm = reference_norm(problem, loads, pressures, loads.response + pressure_response);
    return norm > 0. ? std::max(std::sqrt(std::max(square, 0.)) / norm, epsilon)
                     : std::numeric_limits<double>::infinity();
  }
} // namespace abut
