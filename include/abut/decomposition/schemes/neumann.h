// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/scheme.h>

namespace abut
{
  /**
   * The parallel Neumann scheme, (20)-(21) of the paper [Dyyak]: p^k from the contact law of u^k, every body
   * solves with it (u~), u^{k+1} = gamma u~ + (1 - gamma) u^k.
   *
   * Iteration error, guaranteed: ||u^k - u_theta||_A <= ||u~ - u^k||_A, since the functional's derivative is
   * a(.,.) plus a monotone term. For displacements that answer pressures q^k it is (p^k - q^k) . C (p^k -
   * q^k), which the interface knows. With gamma <= gamma* this bound never grows; a bound that has not fallen
   * over 1/gamma steps ends the run.
   */
  class NeumannScheme : public Scheme
  {
  public:
    NeumannScheme(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                  const DecompositionParameters &parameters, double relaxation);

    /// The response to the pressures; without pressures that push, that of the scene's initial guess.
    InterfaceState first_state(const InterfaceProblem::Loads &loads,
                               const std::optional<Eigen::VectorXd> &pressures) const override;
    SchemeResult solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                       const StepObserver &observer) const override;

  private:
    /// One pass of (20)-(21) and what it tells.
    struct Step
    {
      Eigen::VectorXd pressures;       ///< p^k
      Eigen::VectorXd solved_response; ///< of u~
      InterfaceState next;             ///< u^{k+1}
      double bound;                    ///< ||u~ - u^k||_A
      StepRecord record;
    };
    Step take_step(const InterfaceProblem::Loads &loads, const InterfaceState &state,
                   unsigned int number) const;
    bool reached(const StepRecord &record) const;
    SchemeResult finish(const InterfaceState &state, const Step &last, StoppedBy reason) const;

    const InterfaceProblem &problem_;
    const InterfaceCompliance &compliance_;
    DecompositionParameters parameters_;
    double relaxation_;
  };

  /// The paper's rule may fire by accident in a run that does not converge with the contact of these
  /// pressures: then one sentence, else nothing.
  std::string accident_message(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               double relaxation, const Eigen::VectorXd &pressures);

  /// gamma: the scene's, or made from the largest eigenvalue.
  double choose_relaxation(const InterfaceProblem &problem, const DecompositionParameters &parameters);

  /// gamma = 2 / (1 + lambda_max): equal damping of the slowest and the fastest error.
  double automatic_relaxation(double largest_eigenvalue);

  /// Steps that the slowest error, shrinking by 1 - gamma, needs to fall to `tolerance`.
  double expected_steps(double relaxation, double tolerance);
} // namespace abut
