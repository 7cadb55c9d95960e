// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/contact_guess.h>
#include <abut/decomposition/schemes/newton.h>
#include <abut/scene/scheme_entry.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    constexpr double direct_accuracy = 1e-13;
    constexpr int most_tightenings = 5; // of the inner iteration

    std::string failure(const PivotResult &result, const DecompositionParameters &parameters)
    {
      if (result.too_many)
        return "The scheme newton has not found the parts in contact within Decomposition/Maximum steps = " +
               std::to_string(parameters.maximum_steps);
      if (!result.balanced)
        return "The scheme newton has not found contact forces that balance the floating bodies; check their "
               "loads and what they touch, or add displacement conditions";
      if (result.cycles)
        return "The scheme newton has come back to a set of parts in contact it had left: rounding keeps it "
               "from "
               "deciding between them; give the contacts a small Penalty coefficient or take the scheme "
               "conjugate";
      return "The scheme newton has found the parts in contact, but round-off keeps the error above the "
             "tolerance; raise Decomposition/Tolerance";
    }

    /// The least share that a slave has in what both bodies of its pair yield. A stiff slave has rough
    /// pressures where its cells are fine, which yield no more than that: they have to be as much more
    /// accurate.
    double least_slave_share(const InterfaceProblem &problem)
    {
      double least = 1.;
      problem.for_each_pair([&](const ContactPair &pair, std::size_t) {
        const double slave = pair.slave().young_modulus, master = pair.master().young_modulus;
        if (pair.slave().is_rigid())
          return; // the master carries the pressures
        least = std::min(least, 1. / (1. + slave / master));
      });
      return least;
    }

    /// Tells an observer of each state.
    class StepReport
    {
    public:
      StepReport(const ContactSystem &system, const InterfaceProblem::Loads &loads,
                 const StepObserver &observer)
          : system_(system), loads_(loads), observer_(observer), before_(loads.response)
      {}

      void operator()(const unsigned int step, const PivotState &state)
      {
        Eigen::VectorXd response = loads_.response + state.response;
        response += system_.motions.all.responses * system_.motions.amplitudes(state.motions);
        increment_ = relative_change(system_.problem, response, before_);
        before_ = response;
        if (!observer_)
          return;
        const double error = system_.residual.algebraic(loads_, state.pressures, state.response, response);
        observer_(step_record(system_.problem, step, increment_, error, state.pressures));
      }
      double increment() const { return increment_; }

    private:
      const ContactSystem &system_;
      const InterfaceProblem::Loads &loads_;
      const StepObserver &observer_;
      Eigen::VectorXd before_;
      double increment_ = 0.;
    };
  } // namespace

  SchemeResult NewtonScheme::answer(const InterfaceProblem::Loads &loads, const PivotResult &pivots) const
  {
    const bool finished = !pivots.cycles && !pivots.too_many;
    const Eigen::VectorXd response =
        finished ? pivots.state.response
                 : system_.compliance.apply(system_.problem.law().project(pivots.state.pressures));
    return result_of(loads, pivots.state.pressures, pivots.state.motions, response);
  }

  SchemeResult NewtonScheme::solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                                   const StepObserver &observer) const
  {
    const InterfaceProblem &problem = system_.problem;
    const auto contact = make_pressure_operator(problem, system_.compliance, system_.model);
    const double tolerance = parameters_.tolerance;
    double accuracy = direct_accuracy; // of the systems on active sets
    if (!system_.compliance.is_dense())
      accuracy = std::max(.01 * tolerance * least_slave_share(problem), direct_accuracy);
    ContactGuess state = guess_contact(system_, loads, start.traction);
    StepReport report(system_, loads, observer);
    unsigned int steps = 0;
    for (int tightened = 0;; ++tightened)
    {
      const auto count_on = [&](const unsigned int step, const PivotState &at_step) {
        report(steps + step, at_step);
      };
      const unsigned int steps_left =
          parameters_.maximum_steps - std::min(steps, parameters_.maximum_steps - 1);
      const PivotResult pivots =
          ActiveSetMethod(problem, *contact, system_.motions, accuracy, steps_left)
              .solve(loads.response.head(problem.n_pressures()), state.pressures, state.motions, count_on);
      steps += pivots.steps;
      SchemeResult result = answer(loads, pivots);
      result.steps = steps;
      result.increment = report.increment();
      // Also a state on one of the sets between which rounding cannot decide.
      if (!pivots.too_many && result.iteration_error <= tolerance &&
          system_.motions.is_balanced(result.traction, pivots.state.motions))
        return result;
      const bool may_be_inexact = accuracy > direct_accuracy && tightened < most_tightenings;
      if (pivots.too_many || !may_be_inexact)
      {
        result.stopped_by = pivots.too_many ? StoppedBy::maximum_steps : StoppedBy::stalled;
        result.message = failure(pivots, parameters_);
        return result;
      }
      accuracy = std::max(.01 * accuracy, direct_accuracy);
      state = {result.traction, pivots.state.motions};
    }
  }

  namespace
  {
    SchemeEntry newton_entry()
    {
      SchemeEntry entry{"newton", "primal-dual active set, a few steps whatever penalty and stiffness ratio"};
      entry.expected_solves = [](const DecompositionParameters & /*parameters*/,
                                 const std::size_t n_motions) {
        constexpr double of_active_sets = 40.; // right sides
        return of_active_sets * static_cast<double>(1 + n_motions);
      };
      entry.make = [](const SchemeSetting &setting) -> std::unique_ptr<Scheme> {
        return std::make_unique<NewtonScheme>(*setting.system, setting.parameters);
      };
      return entry;
    }

    const Registered<SchemeEntry> registered_newton(newton_entry());
  } // namespace
} // namespace abut
