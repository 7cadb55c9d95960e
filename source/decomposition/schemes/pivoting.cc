// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/decomposition/schemes/pivoting.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <optional>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr int most_tries = 3;               // of flipping all without progress
    constexpr double first_softness = 1e-6;     // eps of the proximal steps, of the layers' stiffness
    constexpr double smallest_softness = 1e-12; //
    constexpr int most_proximal_steps = 12;
    constexpr double no_residual = 1e-14; // of the forces: no further proximal step

    ActiveSet indices(const std::vector<bool> &active)
    {
      ActiveSet result;
      for (std::size_t i = 0; i < active.size(); ++i)
        if (active[i])
          result.push_back(static_cast<Index>(i));
      return result;
    }
  } // namespace

  bool BlockPivoting::flip(const std::vector<Index> &infeasible, std::vector<bool> &active)
  {
    Assert(std::all_of(infeasible.begin(), infeasible.end(),
                       [&](const Index i) { return i >= 0 && i < static_cast<Index>(active.size()); }),
           dealii::ExcMessage("multipliers of the set"));
    const auto change = [&](const Index i) {
      active[static_cast<std::size_t>(i)] = !active[static_cast<std::size_t>(i)];
    };
    if (is_progress(infeasible.size()))
    {
      fewest_ = infeasible.size();
      tries_ = most_tries;
    }
    if (tries_ == 0)
      return false;
    --tries_;
    std::for_each(infeasible.begin(), infeasible.end(), change);
    return true;
  }

  std::vector<bool> ActiveSetDescent::active() const
  {
    std::vector<bool> result(static_cast<std::size_t>(pressures_.size()));
    for (Index i = 0; i < pressures_.size(); ++i)
      result[static_cast<std::size_t>(i)] = pressures_[i] > 0.;
    return result;
  }

  void ActiveSetDescent::move_towards(const Eigen::VectorXd &solution, std::vector<bool> &active)
  {
    double share = 1.;
    for (std::size_t k = 0; k < active.size(); ++k)
      if (const auto i = static_cast<Index>(k); active[k] && solution[i] < 0.)
        share = std::min(share, pressures_[i] / (pressures_[i] - solution[i]));
    for (std::size_t k = 0; k < active.size(); ++k)
    {
      const auto i = static_cast<Index>(k);
      if (!active[k])
        continue;
      const bool leaves = solution[i] < 0. && pressures_[i] / (pressures_[i] - solution[i]) <= share;
      pressures_[i] = leaves ? 0. : pressures_[i] + share * (solution[i] - pressures_[i]);
      active[k] = !leaves;
    }
  }

  bool ActiveSetDescent::enter(const std::vector<Index> &overlapping, std::vector<bool> &active)
  {
    if (active == last_minimum_) // what had entered has left at once
      ++next_alone_;
    else if (minima_.insert(active).second)
      next_alone_ = 0;
    else
      return false;
    last_minimum_ = active;
    if (next_alone_ > overlapping.size())
      return false;
    for (std::size_t k = 0; k < overlapping.size(); ++k)
      if (next_alone_ == 0 || next_alone_ == k + 1)
        active[static_cast<std::size_t>(overlapping[k])] = true;
    return true;
  }

  bool ActiveSetDescent::advance(const Eigen::VectorXd &solution, const std::vector<Index> &infeasible,
                                 std::vector<bool> &active)
  {
    AssertDimension(solution.size(), pressures_.size());
    AssertDimension(static_cast<Index>(active.size()), pressures_.size());
    const auto pulls = [&](const Index i) { return active[static_cast<std::size_t>(i)]; };
    if (std::any_of(infeasible.begin(), infeasible.end(), pulls))
    {
      move_towards(solution, active);
      return true;
    }
    pressures_ = solution.cwiseMax(0.);
    return enter(infeasible, active);
  }

  ActiveSetMethod::ActiveSetMethod(const InterfaceProblem &problem, const PressureOperator &pressure_operator,
                                   const MotionTerms &motions, const double accuracy,
                                   const unsigned int maximum_steps)
      : problem_(problem), operator_(pressure_operator), motions_(motions), accuracy_(accuracy),
        maximum_steps_(maximum_steps)
  {}

  void ActiveSetMethod::solve_on(const Factored &system, const Eigen::VectorXd &softness,
                                 const Eigen::VectorXd &before, PivotState &state) const
  {
    const auto &y = system.solutions;
    Eigen::VectorXd on_active = y.col(0);
    state.motions = before;
    if (motions_.size() > 0)
    {
      const Eigen::MatrixXd gaps = motions_.gaps(system.active, Eigen::all);
      Eigen::MatrixXd schur = motions_.stiffness + gaps.transpose() * y.rightCols(motions_.size());
      schur.diagonal() += softness;
      // Scaled to a unit diagonal: bodies of very different stiffness.
      const Eigen::VectorXd scaling = schur.diagonal().cwiseSqrt().cwiseInverse();
      // No symmetric factorisation: where the solutions are iterates, the matrix is not quite symmetric, and
      // the balance would be as inexact as they are.
      const Eigen::PartialPivLU<Eigen::MatrixXd> factor(scaling.asDiagonal() * schur * scaling.asDiagonal());
      const Eigen::VectorXd right_side =
          motions_.loads + softness.cwiseProduct(before) + gaps.transpose() * on_active;
      state.motions = scaling.asDiagonal() * factor.solve(scaling.asDiagonal() * right_side);
      on_active -= y.rightCols(motions_.size()) * state.motions;
    }
    state.pressures = Eigen::VectorXd::Zero(problem_.n_pressures());
    state.pressures(system.active) = on_active;
    state.response = operator_.respond(state.pressures);
  }

  std::vector<Index> ActiveSetMethod::infeasible(const Eigen::VectorXd &gaps, const PivotState &state,
                                                 const std::vector<bool> &active) const
  {
    const Index n = problem_.n_pressures();
    const Eigen::VectorXd moved = motions_.gaps * state.motions;
    const Eigen::VectorXd slack = gaps + moved + state.response.head(n);
    const Eigen::ArrayXd sizes =
        gaps.array().abs() + moved.array().abs() + state.response.head(n).array().abs();
    const double gap_size = n > 0 ? (sizes / problem_.weights().array()).maxCoeff() : 0.;
    const double tolerance = 10. * accuracy_, pressure_size = state.pressures.lpNorm<Eigen::Infinity>();
    Eigen::VectorXd violation = Eigen::VectorXd::Zero(n); // by what is allowed
    std::vector<Index> result;
    for (Index i = 0; i < n; ++i)
    {
      const bool pressed = active[static_cast<std::size_t>(i)];
      const double allowed = tolerance * (pressed ? pressure_size : gap_size * problem_.weights()[i]);
      const double missing = pressed ? -state.pressures[i] : -slack[i];
      if (missing > allowed)
      {
        violation[i] = missing / std::max(allowed, std::numeric_limits<double>::min());
        result.push_back(i);
      }
    }
    std::stable_sort(result.begin(), result.end(),
                     [&](const Index i, const Index j) { return violation[i] > violation[j]; });
    return result;
  }

  bool ActiveSetMethod::in_balance(const PivotState &state) const
  {
    return motions_.imbalance(state.pressures, state.motions) <=
           no_residual * motions_.force_scale(state.pressures);
  }

  PivotResult ActiveSetMethod::solve(const Eigen::VectorXd &gaps, const Eigen::VectorXd &pressures,
                                     const Eigen::VectorXd &motions, const Observer &observer) const
  {
    AssertDimension(gaps.size(), problem_.n_pressures());
    AssertDimension(pressures.size(), problem_.n_pressures());
    AssertDimension(motions.size(), motions_.size());
    std::vector<bool> active = problem_.law().active(pressures);
    Eigen::VectorXd softness = first_softness * motions_.layer_stiffness, before = motions;
    PivotResult result;
    BlockPivoting pivoting;
    std::optional<ActiveSetDescent> descent;
    Eigen::VectorXd feasible; // of the set with the fewest infeasible multipliers
    Factored system;
    for (int proximal_steps = 0;;)
    {
      if (result.steps == 0 || indices(active) != system.active)
      {
        system.active = indices(active);
        Eigen::MatrixXd right_sides(static_cast<Index>(system.active.size()), 1 + motions_.size());
        right_sides.col(0) = -gaps(system.active);
        right_sides.rightCols(motions_.size()) = motions_.gaps(system.active, Eigen::all);
        system.solutions =
            system.active.empty() ? right_sides : operator_.solve(system.active, right_sides, accuracy_);
        ++result.steps;
      }
      solve_on(system, softness, before, result.state);
      const std::vector<Index> wrong = infeasible(gaps, result.state, active);
      if (wrong.empty() && ++proximal_steps < most_proximal_steps && !in_balance(result.state))
      {
        before = result.state.motions;
        softness = (.01 * softness).cwiseMax(smallest_softness * motions_.layer_stiffness);
        pivoting = BlockPivoting();
        descent.reset();
        continue;
      }
      if (observer)
        observer(result.steps, result.state);
      if (wrong.empty())
      {
        result.balanced = motions_.is_balanced(result.state.pressures, result.state.motions);
        return result;
      }
      result.too_many = result.steps >= maximum_steps_;
      if (result.too_many)
        return result;
      if (!descent && pivoting.is_progress(wrong.size()))
        feasible = problem_.law().project(result.state.pressures);
      if (descent)
        result.cycles = !descent->advance(result.state.pressures, wrong, active);
      else if (!pivoting.flip(wrong, active))
        active = descent.emplace(feasible).active();
      if (result.cycles)
        return result;
    }
  }
} // namespace abut
