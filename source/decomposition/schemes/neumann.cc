// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/decomposition/measures.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/neumann_step.h>
#include <abut/decomposition/spectrum.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// ||u~ - u^k||_A, the bound of the state that a step starts from; NaN where that state is no field.
    double error_bound(const InterfaceProblem &problem, const InterfaceState &state,
                       const Eigen::VectorXd &pressures, const Eigen::VectorXd &solved_response)
    {
      if (!state.traction)
        return std::numeric_limits<double>::quiet_NaN();
      const Index n = problem.n_pressures();
      const double square = (pressures - *state.traction).dot((solved_response - state.response).head(n));
      return std::sqrt(std::max(square, 0.));
    }

    /// The bound in terms of the reference norm. What lies below round-off is round-off, unless the pressures
    /// agree exactly, e.g. because nothing touches.
    double relative_bound(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                          const InterfaceState &state, const Eigen::VectorXd &pressures, const double bound)
    {
      if (!state.traction || pressures == *state.traction)
        return bound;
      const double norm = reference_norm(problem, loads, *state.traction, state.response);
      return norm > 0. ? std::max(bound / norm, std::numeric_limits<double>::epsilon())
                       : std::numeric_limits<double>::infinity();
    }

    /// Steps over which a converging run's error falls visibly: 1/gamma, at least 10.
    std::size_t stall_window(const double relaxation)
    {
      return static_cast<std::size_t>(std::max(10., std::ceil(1. / relaxation)));
    }

    /// Notices that a measure of the error has not fallen over a number of steps.
    class StallDetector
    {
    public:
      explicit StallDetector(const std::size_t window) : window_(window) {}
      bool stalled(const double measure)
      {
        history_.push_back(measure);
        if (history_.size() <= window_)
          return false;
        const double before = history_.front();
        history_.pop_front();
        return !(measure < .99 * before); // also for zeros, which round-off makes
      }

    private:
      std::size_t window_;
      std::deque<double> history_;
    };

    std::string stall_message(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                              const double relaxation, const std::size_t window,
                              const Eigen::VectorXd &pressures)
    {
      const double everywhere = 2. / largest_eigenvalue(problem, compliance);
      const double here = 2. / largest_eigenvalue(problem, compliance, &pressures);
      std::ostringstream text;
      text.precision(3);
      text << "The parallel Neumann scheme ";
      if (relaxation < everywhere)
        text << "has stalled: over the last " << window
             << " steps its error bound has not fallen, although gamma = " << relaxation
             << " is below gamma* = " << everywhere
             << ". The tolerance asked for is below what round-off leaves; raise Decomposition/Tolerance";
      else
        text << "does not converge with gamma = " << relaxation << ": over the last " << window
             << " steps its error has not fallen. gamma must stay below gamma* = " << everywhere
             << " (contact on the whole side; " << here
             << " on the present contact). Set Decomposition/Relaxation to automatic or to a smaller number";
      return text.str();
    }
  } // namespace

  std::string accident_message(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const double relaxation, const Eigen::VectorXd &pressures)
  {
    if (relaxation < 2. / largest_eigenvalue(problem, compliance))
      return {};
    const double here = 2. / largest_eigenvalue(problem, compliance, &pressures);
    if (relaxation < here)
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "The increment rule has stopped the parallel Neumann scheme, but with gamma = " << relaxation
         << " it does not converge: gamma must stay below gamma* = " << here
         << " on the present contact. Set Decomposition/Relaxation to automatic or to a smaller number";
    return text.str();
  }

  double automatic_relaxation(const double largest_eigenvalue)
  {
    return 2. / (1. + largest_eigenvalue);
  }

  double expected_steps(const double relaxation, const double tolerance)
  {
    return relaxation < 1. ? std::log(tolerance) / std::log1p(-relaxation) : 1.;
  }

  NeumannScheme::NeumannScheme(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                               const DecompositionParameters &parameters, const double relaxation)
      : problem_(problem), compliance_(compliance), parameters_(parameters), relaxation_(relaxation)
  {}

  NeumannScheme::Step NeumannScheme::take_step(const InterfaceProblem::Loads &loads,
                                               const InterfaceState &state, const unsigned int number) const
  {
    auto [pressures, solved, next] = take_neumann_step(
        problem_, relaxation_, state.response, state.response,
        [&](const Eigen::VectorXd &p) { return respond_to(compliance_, loads, p).response; });
    Step step;
    step.bound = error_bound(problem_, state, pressures, solved);
    step.record = step_record(problem_, number, relative_change(problem_, next, state.response),
                              relative_bound(problem_, loads, state, pressures, step.bound), pressures);
    if (state.traction)
      step.next.traction = relaxed(relaxation_, pressures, *state.traction);
    step.next.response = std::move(next);
    step.solved_response = std::move(solved);
    step.pressures = std::move(pressures);
    if (!step.solved_response.head(problem_.n_pressures()).allFinite() ||
        !std::isfinite(step.record.increment))
      throw ComputationError(
          "The parallel Neumann scheme has left the range of the machine's numbers after " +
          std::to_string(number) +
          " steps; set Decomposition/Relaxation to automatic or to a smaller number");
    return step;
  }

  bool NeumannScheme::reached(const StepRecord &record) const
  {
    const bool by_bound = parameters_.stopping_rule == StoppingRule::bound;
    return (by_bound ? record.bound : record.increment) <= parameters_.tolerance;
  }

  SchemeResult NeumannScheme::finish(const InterfaceState &state, const Step &last,
                                     const StoppedBy reason) const
  {
    SchemeResult result;
    result.stopped_by = reason;
    result.steps = last.record.step;
    result.relaxation = relaxation_;
    result.increment = last.record.increment;
    result.iteration_error = last.record.bound;
    // Without a field for u^k, the last solved displacement and its traction are a pair in equilibrium.
    result.traction = state.traction ? *state.traction : last.pressures;
    result.response = state.traction ? state.response : last.solved_response;
    result.iterate = state.response;
    if (reason == StoppedBy::increment)
      result.message = accident_message(problem_, compliance_, relaxation_, last.pressures);
    else if (reason == StoppedBy::stalled)
      result.message =
          stall_message(problem_, compliance_, relaxation_, stall_window(relaxation_), last.pressures);
    else if (reason == StoppedBy::maximum_steps)
      result.message =
          "The parallel Neumann scheme has not reached the tolerance within Decomposition/Maximum steps = " +
          std::to_string(parameters_.maximum_steps);
    return result;
  }

  InterfaceState NeumannScheme::first_state(const InterfaceProblem::Loads &loads,
                                            const std::optional<Eigen::VectorXd> &pressures) const
  {
    // Bodies that do not overlap under their loads do not press: an older traction would only have to decay.
    const bool overlaps = !problem_.pressures(loads.response).isZero(0.);
    return pressures && overlaps ? respond_to(compliance_, loads, *pressures)
                                 : initial_guess(problem_, compliance_, loads, parameters_.initial_guess);
  }

  SchemeResult NeumannScheme::solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                                    const StepObserver &observer) const
  {
    InterfaceState state = start;
    // The bound needs a field: where the guess is none, the response to its traction takes its place.
    if (!state.traction && parameters_.stopping_rule == StoppingRule::bound)
      state = respond_to(compliance_, loads, problem_.pressures(state.response));
    StallDetector detector(stall_window(relaxation_));
    for (unsigned int number = 1;; ++number)
    {
      Step step = take_step(loads, state, number);
      step.record.answered = state.traction ? &*state.traction : nullptr;
      step.record.applied = &step.pressures;
      if (observer)
        observer(step.record);
      // The bound belongs to the state that the step began with, the increment to the one it has made.
      if (reached(step.record) && parameters_.stopping_rule == StoppingRule::bound)
        return finish(state, step, StoppedBy::bound);
      if (reached(step.record))
        return finish(step.next, step, StoppedBy::increment);
      if (detector.stalled(state.traction ? step.bound : step.record.increment))
        return finish(state, step, StoppedBy::stalled);
      if (number >= parameters_.maximum_steps)
        return finish(state, step, StoppedBy::maximum_steps);
      state = std::move(step.next);
    }
  }
} // namespace abut
