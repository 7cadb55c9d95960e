// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/motion_terms.h>
#include <abut/decomposition/pressure_operator.h>

#include <deal.II/base/exceptions.h>

#include <functional>
#include <set>

namespace abut
{
  /**
   * Block principal pivoting: all infeasible multipliers change their side [JudicePires1994]. A few
   * steps where it works, but it need not end.
   */
  class BlockPivoting
  {
  public:
    /// Changes `active` (one entry for each multiplier). False, with nothing changed, where the number of the
    /// infeasible has not fallen in three tries.
    bool flip(const std::vector<Eigen::Index> &infeasible, std::vector<bool> &active);
    /// Whether these are fewer than ever.
    bool is_progress(const std::size_t n_infeasible) const { return n_infeasible < fewest_; }

  private:
    std::size_t fewest_ = static_cast<std::size_t>(-1);
    int tries_ = 0;
  };

  /**
   * The way out: pressures p >= 0 move towards the solution on the active set as far as they stay
   * nonnegative, and those that become zero leave it; where all of the way was gone, those that overlap
   * enter, all together or, where that led back, the worst alone. The energy falls from one minimum on a set
   * to the next, so that no set comes back [LawsonHanson1974, ch. 23].
   */
  class ActiveSetDescent
  {
  public:
    /// `pressures` >= 0; the positive ones are active.
    explicit ActiveSetDescent(const Eigen::VectorXd &pressures) : pressures_(pressures)
    {
      Assert(!(pressures.array() < 0.).any(), dealii::ExcMessage("the way begins where nothing pulls"));
    }

    std::vector<bool> active() const;
    /// The next active set, from the solution on the present one and its infeasible multipliers, the worst
    /// first. False where rounding makes a set come back or nothing can enter.
    bool advance(const Eigen::VectorXd &solution, const std::vector<Eigen::Index> &infeasible,
                 std::vector<bool> &active);

  private:
    /// Moves as far as nothing becomes negative.
    void move_towards(const Eigen::VectorXd &solution, std::vector<bool> &active);
    bool enter(const std::vector<Eigen::Index> &overlapping, std::vector<bool> &active);

    Eigen::VectorXd pressures_;
    std::set<std::vector<bool>> minima_; ///< the sets on which the way was gone
    std::vector<bool> last_minimum_;
    std::size_t next_alone_ = 0; ///< which of the overlapping enters alone; 0: all together
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
    bool cycles = false;    ///< by rounding
    bool too_many = false;  ///< steps
    bool balanced = true;
  };

  /**
   * Primal-dual active-set method (a semismooth Newton method) for
   *
   *     s = (C + theta D) p + G alpha + g_L >= 0,  p >= 0,  p . s = 0,  H alpha = e + G^T p.
   *
   * Each step solves on the active set, which block pivoting changes and, where it does not get on,
   * ActiveSetDescent. Floating bodies need no contact in the set: H is replaced by H + eps
   * with a pull back to the last alpha (the proximal point method [Rockafellar1976]), which is repeated with
   * ever smaller eps until the bodies balance. The limit does not depend on eps; a motion that the contact
   * leaves undetermined stays where it was.
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
    /// The worst first.
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
