// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/contact_guess.h>
#include <abut/decomposition/neumann.h>
#include <abut/decomposition/newton.h>
#include <abut/decomposition/pivoting.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double direct_accuracy = 1e-13;
    constexpr int most_tightenings = 5; // of the inner iteration

    std::string failure(const PivotResult &result, const DecompositionParameters &parameters)
    {
      if (result.cycles)
        return "The scheme newton has come back to a set of contact nodes it had left: rounding keeps it "
               "from "
               "deciding between them; give the contacts a small Penalty coefficient or take the scheme "
               "conjugate";
      if (result.too_many)
        return "The scheme newton has not found the nodes in contact within Decomposition/Maximum steps = " +
               std::to_string(parameters.maximum_steps);
      if (!result.balanced)
        return "The scheme newton has not found contact forces that balance the floating bodies; check their "
               "loads and what they touch, or add displacement conditions";
      return {};
    }

    /// Tells an observer of each state.
    class StepReport
    {
    public:
      StepReport(const InterfaceProblem &problem, const ContactResidual &residual, const MotionTerms &motions,
                 const InterfaceProblem::Loads &loads, const StepObserver &observer)
          : problem_(problem), residual_(residual), motions_(motions), loads_(loads), observer_(observer),
            before_(loads.response)
      {}

      void operator()(const unsigned int step, const PivotState &state)
      {
        Eigen::VectorXd response = loads_.response + state.response;
        response += motions_.all.responses * motions_.amplitudes(state.motions);
        increment_ = relative_change(problem_, response, before_);
        before_ = response;
        if (!observer_)
          return;
        const double error = residual_.algebraic(loads_, state.pressures, state.response, response);
        observer_({step, increment_, error, problem_.weights().dot(state.pressures),
                   state.pressures.size() > 0 ? state.pressures.maxCoeff() : 0.});
      }
      double increment() const { return increment_; }

    private:
      const InterfaceProblem &problem_;
      const ContactResidual &residual_;
      const MotionTerms &motions_;
      const InterfaceProblem::Loads &loads_;
      const StepObserver &observer_;
      Eigen::VectorXd before_;
      double increment_ = 0.;
    };
  } // namespace

  SchemeResult contact_result(const InterfaceProblem &problem, const ContactResidual &residual,
                              const MotionTerms &motions, const InterfaceProblem::Loads &loads,
                              const Eigen::VectorXd &pressures, const Eigen::VectorXd &amplitudes,
                              const Eigen::VectorXd &pressure_response, const double tolerance)
  {
    SchemeResult result;
    result.traction = pressures.cwiseMax(0.);
    result.motions = motions.amplitudes(amplitudes);
    result.response = loads.response + pressure_response + motions.all.responses * result.motions;
    result.iterate = result.response;
    const bool bounded =
        motions.size() == 0 && problem.n_pressures() > 0 && (problem.penalties().array() > 0.).all();
    if (bounded)
      result.iteration_error =
          residual.guaranteed(loads, result.traction, pressure_response, result.response);
    result.error_is_bound = bounded && result.iteration_error <= tolerance;
    if (!result.error_is_bound)
      result.iteration_error = residual.algebraic(loads, result.traction, pressure_response, result.response);
    result.stopped_by = result.error_is_bound ? StoppedBy::bound : StoppedBy::residual;
    return result;
  }

  NewtonScheme::NewtonScheme(const InterfaceProblem &problem, const InterfaceCompliance &compliance,
                             const MotionTerms &motions, const DecompositionParameters &parameters)
      : problem_(problem), compliance_(compliance), motions_(motions), parameters_(parameters),
        residual_(problem, compliance)
  {}

  SchemeResult NewtonScheme::solve(const InterfaceProblem::Loads &loads, const InterfaceState &start,
                                   const StepObserver &observer) const
  {
    const Eigen::MatrixXd model = suits_model(compliance_) ? model_compliance(problem_) : Eigen::MatrixXd();
    const auto contact = make_pressure_operator(problem_, compliance_, model);
    const ContactGuess guess = guess_contact(problem_, motions_, loads, model);
    Eigen::VectorXd pressures = start.traction ? *start.traction : guess.pressures, motions = guess.motions;
    double accuracy =
        compliance_.is_dense() ? direct_accuracy : std::max(.01 * parameters_.tolerance, direct_accuracy);
    StepReport report(problem_, residual_, motions_, loads, observer);
    unsigned int steps = 0;
    for (int tightened = 0;; ++tightened)
    {
      const auto count_on = [&](const unsigned int step, const PivotState &state) {
        report(steps + step, state);
      };
      const PivotResult pivots =
          ActiveSetMethod(problem_, *contact, motions_, accuracy,
                          parameters_.maximum_steps - std::min(steps, parameters_.maximum_steps - 1))
              .solve(loads.response.head(problem_.n_pressures()), pressures, motions, count_on);
      steps += pivots.steps;
      const std::string message = failure(pivots, parameters_);
      // An unfinished state may pull: what is reported answers the pressures that push.
      const Eigen::VectorXd response =
          message.empty() ? pivots.state.response : compliance_.apply(pivots.state.pressures.cwiseMax(0.));
      SchemeResult result = contact_result(problem_, residual_, motions_, loads, pivots.state.pressures,
                                           pivots.state.motions, response, parameters_.tolerance);
      result.steps = steps;
      result.increment = report.increment();
      result.message = message;
      if (!result.message.empty())
        result.stopped_by = pivots.too_many ? StoppedBy::maximum_steps : StoppedBy::stalled;
      if (!result.message.empty() || result.iteration_error <= parameters_.tolerance)
        return result;
      if (accuracy <= direct_accuracy || tightened == most_tightenings)
      {
        result.stopped_by = StoppedBy::stalled;
        result.message =
            "The scheme newton has found the nodes in contact, but round-off keeps the error above "
            "the tolerance; raise Decomposition/Tolerance";
        return result;
      }
      accuracy = std::max(.01 * accuracy, direct_accuracy);
      pressures = result.traction;
      motions = pivots.state.motions;
    }
  }
} // namespace abut
