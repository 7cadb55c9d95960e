// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_guess.h>
#include <abut/decomposition/pivoting.h>

namespace abut
{
  namespace
  {
    ContactGuess solve_with(const PressureOperator &pressure_operator, const InterfaceProblem &problem,
                            const MotionTerms &motions, const InterfaceProblem::Loads &loads,
                            const ContactGuess &start)
    {
      constexpr double accuracy = 1e-13;
      constexpr unsigned int most_steps = 1000;
      const PivotState state =
          ActiveSetMethod(problem, pressure_operator, motions, accuracy, most_steps)
              .solve(loads.response.head(problem.n_pressures()), start.pressures, start.motions, {})
              .state;
      return {state.pressures.cwiseMax(0.), state.motions};
    }
  } // namespace

  ContactGuess guess_contact(const InterfaceProblem &problem, const MotionTerms &motions,
                             const InterfaceProblem::Loads &loads, const Eigen::MatrixXd &model)
  {
    const ContactGuess overlap{(-loads.response.head(problem.n_pressures())).cwiseMax(0.),
                               Eigen::VectorXd::Zero(motions.size())};
    const ContactGuess layers = solve_with(*make_layer_operator(problem), problem, motions, loads, overlap);
    return model.size() > 0
               ? solve_with(*make_model_operator(problem, model), problem, motions, loads, layers)
               : layers;
  }
} // namespace abut
