// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_problem.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  /// gamma u~ + (1 - gamma) u, the mixture of (21).
  inline Eigen::VectorXd relaxed(const double gamma, const Eigen::VectorXd &solved, const Eigen::VectorXd &u)
  {
    return gamma * solved + (1. - gamma) * u;
  }
  /// The same body by body.
  inline std::vector<Eigen::VectorXd> relaxed(const double gamma, const std::vector<Eigen::VectorXd> &solved,
                                              const std::vector<Eigen::VectorXd> &u)
  {
    AssertDimension(solved.size(), u.size());
    std::vector<Eigen::VectorXd> mixture;
    for (std::size_t a = 0; a < u.size(); ++a)
      mixture.push_back(relaxed(gamma, solved[a], u[a]));
    return mixture;
  }

  /// What (20)-(21) make of u^k. Displacements are responses (see InterfaceProblem) or fields of all bodies.
  template <typename Displacement> struct NeumannStep
  {
    Eigen::VectorXd pressures; ///< p^k, what the contact law makes of u^k
    Displacement solved;       ///< u~, the bodies' answer to them and to the loads
    Displacement next;         ///< u^{k+1} = gamma u~ + (1 - gamma) u^k
  };

  /// `response`: that of u^k. `answer(p)` is the displacement of all bodies under pressures p, and loads.
  template <typename Displacement, typename Answer>
  NeumannStep<Displacement> take_neumann_step(const InterfaceProblem &problem, const double gamma,
                                              const Displacement &u, const Eigen::VectorXd &response,
                                              const Answer &answer)
  {
    AssertDimension(response.size(), problem.response_size());
    Assert(gamma > 0., dealii::ExcMessage("the relaxation is positive"));
    const Eigen::VectorXd pressures = problem.pressures(response);
    const Displacement solved = answer(pressures);         // (20)
    return {pressures, solved, relaxed(gamma, solved, u)}; // (21)
  }
} // namespace abut
