// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_solver.h>
#include <abut/run/pass.h>

namespace abut
{
  /**
   * Solves the decomposition to the tolerance, then estimates. Where meshes adapt the tolerance is
   * `Iteration fraction` of the estimated discretisation error: the pass begins with a guess and goes on
   * until the estimate agrees.
   */
  class SolvedPass : public Pass
  {
  public:
    explicit SolvedPass(const Setup &setup) : Pass(setup) {}
    PassOutcome run(const std::optional<CarriedState> &carried, const RunObserver &observer) override;
    std::optional<LimitDistance> limit_distance(const Solution &solution) const override;
    std::vector<std::string> dropped_loads() const override;
    void serialize(Archive &archive) override
    {
      Pass::serialize(archive);
      archive(discretisation_);
    }

  protected:
    std::optional<PenaltyChange> penalty_change(const Eigen::VectorXd &pressures) const override;

  private:
    double first_tolerance() const;
    /// Empty where the iteration error has its share of the discretisation error, else the tolerance that
    /// gives it that.
    std::optional<double> next_tolerance(const PassOutcome &outcome) const;
    /// Whether the tolerance follows the estimate.
    bool follows_estimate() const;
    /// `guess`: of the displacement of a rigid side. Sets the iteration and that displacement.
    void solve_interface(const std::optional<Eigen::VectorXd> &start, double guess, double tolerance,
                         const StepObserver &observer, Solution &solution) const;

    std::unique_ptr<InterfaceSolver> solver_; ///< of the present mesh
    double discretisation_ = .1;              ///< estimated in the pass before; a guess in the first
  };
} // namespace abut
