// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/spectrum.h>

#include <algorithm>

namespace abut
{
  InterfaceSolver::InterfaceSolver(const InterfaceProblem &problem, const DecompositionParameters &parameters)
      : problem_(problem), entry_(scheme_of(parameters)),
        parameters_(entry_.chosen != nullptr ? entry_.chosen(problem, parameters) : parameters)
  {
    const auto make = [&](const std::size_t n_motions) {
      return make_compliance(problem, parameters.compliance, entry_.expected_solves(parameters_, n_motions));
    };
    if (!entry_.takes_motions)
    {
      compliance_ = make(0);
      return;
    }
    MotionTerms motions = make_motion_terms(problem);
    compliance_ = make(static_cast<std::size_t>(motions.size()));
    system_ = std::make_unique<ContactSystem>(problem, *compliance_, std::move(motions));
    held_.emplace(problem, *compliance_, system_->motions);
  }

  SchemeResult InterfaceSolver::solve(const InterfaceProblem::Loads &loads,
                                      const std::optional<Eigen::VectorXd> &start,
                                      const StepObserver &observer,
                                      const std::optional<double> &tolerance) const
  {
    DecompositionParameters parameters = parameters_;
    if (tolerance && parameters.stopping_rule == StoppingRule::bound)
      parameters.tolerance = *tolerance;
    const auto scheme = entry_.make({problem_, *compliance_, system_.get(), parameters});
    const auto solve_from = [&](const InterfaceProblem::Loads &all,
                                const std::optional<Eigen::VectorXd> &from) {
      return scheme->solve(all, scheme->first_state(all, from), observer);
    };
    if (!held_)
      return solve_from(loads, start);
    std::optional<Eigen::VectorXd> from = start;
    if (from)
      (*from)(held_->indices()).setZero();
    return solve_from(held_->opened(loads), from);
  }

  PenaltyChange InterfaceSolver::penalty_change(const Eigen::VectorXd &pressures) const
  {
    return abut::penalty_change(problem_, *compliance_, motions(), pressures);
  }

  SchemeResult InterfaceSolver::limit(const InterfaceProblem::Loads &loads,
                                      const Eigen::VectorXd &start) const
  {
    constexpr double most_products = 1e10; // of numbers: some ten seconds
    const double entries =
        static_cast<double>(problem_.n_pressures()) * static_cast<double>(problem_.response_size());
    DecompositionParameters to_the_end = parameters_;
    to_the_end.stopping_rule = StoppingRule::bound;
    to_the_end.tolerance = 1e-10;
    to_the_end.maximum_steps =
        static_cast<unsigned int>(std::max(1e3, std::min(1e6, most_products / entries)));
    const double relaxation = automatic_relaxation(largest_eigenvalue(problem_, *compliance_));
    return NeumannScheme(problem_, *compliance_, to_the_end, relaxation)
        .solve(loads, respond_to(*compliance_, loads, start), {});
  }
} // namespace abut
