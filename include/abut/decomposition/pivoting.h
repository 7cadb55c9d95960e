// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/motion_terms.h>
#include <abut/decomposition/pressure_operator.h>

#include <functional>
#include <set>

namespace abut
{
  /**
   * Block principal pivoting: all infeasible multipliers change their side; when their number has not
   * decreased in three tries, only the last one does until it has. Finite for positive definite matrices; see
   * Judice and Pires, Comput. Oper. Res. 21 (1994) 587. Rounding can make it return to a set nevertheless.
   */
  class BlockPivoting
  {
  public:
    /// Changes `active` (one entry for each multiplier). False where the set comes back while single
    /// multipliers change: a cycle.
    bool flip(const std::vector<Eigen::Index> &infeasible, std::vector<bool> &active);

  private:
    std::size_t fewest_ = static_cast<std::size_t>(-1);
    int tries_ = 0;
    std::set<std::vector<bool>> seen_;
  };

  /// A state of the active-set iteration: the solution on an active set.
  struct PivotState
  {
    Eigen::VectorXd pressures; ///< may be negative before the last step
    Eigen::VectorXd motions;   ///< amplitudes of the held motions
    Eigen::VectorXd response;  ///< Z p of the operator
  };

  struct PivotResult
  {
    PivotState state;
    unsigned int steps = 0; ///< systems on active sets that were solved
    bool cycles = false;
    bool too_many = false; ///< steps
    bool balanced = true;
  };

  /**
   * Primal-dual active-set method (a semismooth Newton method) for
   *
   *     s = (C + theta D) p + G alpha + g_L >= 0,  p >= 0,  p . s = 0,  H alpha = e + G^T p.
   *
   * Each step solves on the active set. Floating bodies need no contact in the set: H is replaced by H + eps
   * with a pull back to the last alpha (the proximal point method, Rockafellar, SIAM J. Control Optim. 14
   * (1976) 877), which is repeated with ever smaller eps until the bodies balance. The limit does not depend
   * on eps; a motion that the contact leaves undetermined stays where it was.
   */
  class ActiveSetMethod
  {
  public:
    using Observer = std::function<void(unsigned int step, const PivotState &)>;

    ActiveSetMethod(const InterfaceProblem &problem, const PressureOperator &pressure_operator,
                    const MotionTerms &motions, double accuracy, unsigned int maximum_steps);

    /// `gaps`: gap integrals under the loads alone. Begins with the positive entries of `pressures` active.
    /// The observer is told of the last state on each active set.
    PivotResult solve(const Eigen::VectorXd &gaps, const Eigen::VectorXd &pressures,
                      const Eigen::VectorXd &motions, const Observer &observer) const;

  private:
    struct Factored
    {
      ActiveSet active;
      Eigen::MatrixXd solutions; ///< of the gaps (first column) and of G, both with minus signs but the last
    };
    void solve_on(const Factored &system, const Eigen::VectorXd &softness, const Eigen::VectorXd &before,
                  PivotState &state) const;
    std::vector<Eigen::Index> infeasible(const Eigen::VectorXd &gaps, const PivotState &state,
                                         const std::vector<bool> &active) const;
    bool in_balance(const PivotState &state) const;

    const InterfaceProblem &problem_;
    const PressureOperator &operator_;
    const MotionTerms &motions_;
    double accuracy_;
    unsigned int maximum_steps_;
  };
} // namespace abut
