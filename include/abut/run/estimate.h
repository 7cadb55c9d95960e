// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/cell_marks.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>
#include <abut/run/setup.h>

namespace abut
{
  /// Of every body's deformation, against what the body answers its `estimate_forces` with. `unseen`: what
  /// the errors of cells are no smaller than, where it does not stand beside them (Estimation::mismatch).
  Estimation estimate(const Indicator &indicator, const AdaptationParameters &parameters,
                      const std::vector<BodyResult> &bodies, const Executor &executor = {},
                      const ContactMismatch *unseen = nullptr);

  /// Whether the goal of a scene with a tolerance is near, by cheap estimates.
  class GoalDistance
  {
  public:
    explicit GoalDistance(const double tolerance) : tolerance_(tolerance) {}
    bool is_near(const Estimation &cheap) const;
    /// Learns what cheap estimates are worth from a better one of the same solution.
    void learn(const Estimation &cheap, const Estimation &better);
    /// An estimate's bound, or what a better one would say.
    double expected(const Estimation &cheap) const;

    /// What it has learnt.
    void serialize(Archive &archive) { archive(ratio_); }

  private:
    double tolerance_;
    std::optional<double> ratio_; ///< better by cheap
  };

  /// The estimate that the scene asks for, of a whole solution; sets what the bodies keep of it
  /// (`estimate_forces`, `eta`, `better`). The setup has an indicator.
  Estimation estimate_solution(const Setup &setup, Solution &solution, GoalDistance &distance);

  /**
   * The cells to be changed after the last pass, body by body: those that the marking of the scene chooses in
   * bodies that adapt, and the cells on both sides of contact that is smaller than a cell
   * (`PairResult::missed`). All processes have to call it.
   */
  std::vector<CellMarks> mark_all(const Scene &scene, const Estimation &estimation, const Results &results,
                                  const Executor &executor);
} // namespace abut
