// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/interface_solver.h>
#include <abut/decomposition/schemes/conjugate.h>
#include <abut/decomposition/schemes/initial_guess.h>
#include <abut/decomposition/schemes/neumann.h>
#include <abut/decomposition/schemes/newton.h>
#include <abut/decomposition/spectrum.h>

#include <algorithm>

namespace abut
{
  double choose_relaxation(const InterfaceProblem &problem, const DecompositionParameters &parameters)
  {
    if (parameters.relaxation)
      return *parameters.relaxation;
    return automatic_relaxation(
        largest_eigenvalue(problem, *make_compliance(problem, ComplianceMode::solves, 0.)));
  }

  namespace
  {
    /// Solves of each body that a scheme takes, roughly.
    double expected_solves(const DecompositionParameters &parameters, const double relaxation,
                           const std::size_t n_motions)
    {
      constexpr double of_active_sets = 40., of_conjugate_gradients = 25.;
      switch (parameters.scheme)
      {
      case SchemeKind::newton:
        return of_active_sets * static_cast<double>(1 + n_motions); // right sides
      case SchemeKind::conjugate:
        return of_conjugate_gradients;
      case SchemeKind::neumann:
        break;
      }
      return expected_steps(relaxation, parameters.tolerance);
    }
  } // namespace

  InterfaceSolver::InterfaceSolver(const InterfaceProblem &problem, const DecompositionParameters &parameters)
      : problem_(problem), parameters_(parameters)
  {
    const auto make = [&](const std::size_t n_motions) {
      return make_compliance(problem, parameters.compliance,
                             expected_solves(parameters, relaxation_, n_motions));
    };
    if (parameters.scheme == SchemeKind::neumann)
    {
      relaxation_ = choose_relaxation(problem, parameters);
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
    if (parameters.scheme == SchemeKind::neumann)
      return solve_neumann(loads, start, observer, parameters);
    const InterfaceProblem::Loads opened = held_->opened(loads);
    InterfaceState state{start, {}};
    if (state.traction)
      (*state.traction)(held_->indices()).setZero();
    if (parameters.scheme == SchemeKind::newton)
      return NewtonScheme(*system_, parameters).solve(opened, state, observer);
    return ConjugateScheme(*system_, parameters).solve(opened, state, observer);
  }

  SchemeResult InterfaceSolver::solve_neumann(const InterfaceProblem::Loads &loads,
                                              const std::optional<Eigen::VectorXd> &start,
                                              const StepObserver &observer,
                                              const DecompositionParameters &parameters) const
  {
    // Bodies that do not overlap under their loads do not press: an older traction would only have to decay.
    const bool overlaps = !problem_.pressures(loads.response).isZero(0.);
    const InterfaceState state =
        start && overlaps ? respond_to(*compliance_, loads, *start)
                          : initial_guess(problem_, *compliance_, loads, parameters_.initial_guess);
    return NeumannScheme(problem_, *compliance_, parameters, relaxation_).solve(loads, state, observer);
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
