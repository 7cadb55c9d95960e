// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/initial_guess.h>
#include <abut/decomposition/neumann.h>
#include <abut/decomposition/spectrum.h>
#include <abut/user_error.h>

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

    /// max_a ||u_an - v_an||_2 / ||u_an||_2 over the nodes of all contact sides of each body, the paper's
    /// norm.
    double relative_change(const InterfaceProblem &problem, const Eigen::VectorXd &u,
                           const Eigen::VectorXd &v)
    {
      double largest = 0.;
      for (std::size_t a = 0; a < problem.bodies().size(); ++a)
      {
        const Eigen::VectorXd now = problem.normal_displacements(u, a);
        const double change = (now - problem.normal_displacements(v, a)).norm();
        if (change > 0.)
          largest = std::max(largest, change / now.norm());
      }
      return largest;
    }

    /// ||u||_A for the displacement that answers the loads and pressures q.
    double energy_norm(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                       const Eigen::VectorXd &pressures, const Eigen::VectorXd &response)
    {
      const Index n = problem.n_pressures();
      const double product = loads.energy_product + 2. * pressures.dot(loads.force_gap) +
                             pressures.dot(response.head(n) - loads.response.head(n));
      return std::sqrt(std::max(product, 0.));
    }

    /// The bound of the state that a step starts from, relative; NaN where that state is no field.
    double relative_bound(const InterfaceProblem &problem, const InterfaceProblem::Loads &loads,
                          const InterfaceState &state, const Eigen::VectorXd &pressures,
                          const Eigen::VectorXd &next_response)
    {
      if (!state.traction)
        return std::numeric_limits<double>::quiet_NaN();
      const Eigen::VectorXd residual = pressures - *state.traction;
      if (residual.isZero(0.))
        return 0.; // u^k solves the problem, e.g. because nothing touches
      const Index n = problem.n_pressures();
      const double square = residual.dot(next_response.head(n) - state.response.head(n));
      const double bound =
          std::sqrt(std::max(square, 0.)) / energy_norm(problem, loads, *state.traction, state.response);
      return std::max(bound, std::numeric_limits<double>::epsilon()); // what lies below is round-off
    }

    /// Notices that a measure of the error has not fallen over the last 1/gamma steps (at least 10).
    class StallDetector
    {
    public:
      explicit StallDetector(const double relaxation)
          : window_(static_cast<std::size_t>(std::max(10., std::ceil(1. / relaxation))))
      {}
      bool stalled(const double measure)
      {
        history_.push_back(measure);
        if (history_.size() <= window_)
          return false;
        const double before = history_.front();
        history_.pop_front();
        return measure > .99 * before;
      }
      std::size_t window() const { return window_; }

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
    /// The paper's rule may fire by accident in a run that does not converge: then a sentence, else nothing.
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
  } // namespace

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

  SchemeResult NeumannScheme::solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                                    const StepObserver &observer) const
  {
    const double gamma = relaxation_;
    InterfaceState state = start;
    // The bound needs a field: where the guess is none, the response to its traction takes its place.
    if (!state.traction && parameters_.stopping_rule == StoppingRule::bound)
      state = respond_to(compliance_, loads, problem_.pressures(state.response));
    StallDetector detector(gamma);
    SchemeResult result;
    result.relaxation = gamma;
    while (true)
    {
      const Eigen::VectorXd pressures = problem_.pressures(state.response);
      const InterfaceState solved = respond_to(compliance_, loads, pressures); // u~ of (20)
      InterfaceState next{std::nullopt, gamma * solved.response + (1. - gamma) * state.response};
      if (state.traction)
        next.traction = gamma * pressures + (1. - gamma) * *state.traction;

      const StepRecord record{++result.steps, relative_change(problem_, next.response, state.response),
                              relative_bound(problem_, loads, state, pressures, solved.response),
                              problem_.weights().dot(pressures),
                              pressures.size() > 0 ? pressures.maxCoeff() : 0.};
      if (!std::isfinite(record.increment) || !solved.response.head(problem_.n_pressures()).allFinite())
        throw ComputationError(
            "The parallel Neumann scheme has left the range of the machine's numbers after " +
            std::to_string(record.step) +
            " steps; set Decomposition/Relaxation to automatic or to a smaller number");
      if (observer)
        observer(record);

      const bool by_bound =
          parameters_.stopping_rule == StoppingRule::bound && record.bound <= parameters_.tolerance;
      const bool by_increment =
          parameters_.stopping_rule == StoppingRule::increment && record.increment <= parameters_.tolerance;
      const bool stalled =
          !by_bound && !by_increment && detector.stalled(state.traction ? record.bound : record.increment);
      const bool exhausted = result.steps >= parameters_.maximum_steps;
      const bool stop = by_bound || by_increment || stalled || exhausted;
      if (by_increment || !stop) // otherwise the state that the bound belongs to is kept
        state = std::move(next);
      if (!stop)
        continue;

      result.increment = record.increment;
      result.iteration_error = record.bound;
      // Without a field for u^k, the last solved displacement and its traction are a pair in equilibrium.
      result.traction = state.traction ? *state.traction : pressures;
      result.response = state.traction ? state.response : solved.response;
      result.iterate = state.response;
      if (by_bound)
        result.stopped_by = StoppedBy::bound;
      else if (by_increment)
      {
        result.stopped_by = StoppedBy::increment;
        result.message = accident_message(problem_, compliance_, gamma, pressures);
      }
      else if (stalled)
      {
        result.stopped_by = StoppedBy::stalled;
        result.message = stall_message(problem_, compliance_, gamma, detector.window(), pressures);
      }
      else
        result.message = "The parallel Neumann scheme has not reached the tolerance within "
                         "Decomposition/Maximum steps = " +
                         std::to_string(parameters_.maximum_steps);
      return result;
    }
  }
} // namespace abut
