// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/contact_guess.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/pivoting.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    /// The solution with another operator in place of C; the start where that has none.
    ContactGuess solve_with(const PressureOperator &pressure_operator, const ContactSystem &system,
                            const InterfaceProblem::Loads &loads, const ContactGuess &start)
    {
      constexpr double accuracy = 1e-13;
      constexpr unsigned int most_steps = 1000;
      const PivotResult result =
          ActiveSetMethod(system.problem, pressure_operator, system.motions, accuracy, most_steps)
              .solve(loads.response.head(system.problem.n_pressures()), start.pressures, start.motions, {});
      if (result.cycles || result.too_many || !result.balanced)
        return start;
      return {system.problem.law().project(result.state.pressures), result.state.motions};
    }
  } // namespace

  ContactGuess guess_contact(const ContactSystem &system, const InterfaceProblem::Loads &loads,
                             const std::optional<Eigen::VectorXd> &pressures)
  {
    Assert(!pressures || pressures->size() == system.problem.n_pressures(),
           dealii::ExcMessage("a pressure for every multiplier"));
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(system.motions.size());
    if (pressures && system.motions.size() == 0)
      return {system.problem.law().project(*pressures), at_rest};
    const ContactGuess resting{layer_pressures(system.problem, loads, system.problem.penalties()), at_rest};
    const ContactGuess layers = solve_with(*make_layer_operator(system.problem), system, loads, resting);
    ContactGuess guess = solve_with(system.model, system, loads, layers);
    if (pressures)
      guess.pressures = system.problem.law().project(*pressures);
    return guess;
  }
} // namespace abut
