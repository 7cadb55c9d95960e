// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/run/model.h>

namespace abut
{
  /**
   * Where the linear, frictionless model ends, or the mesh: what a run says beside its numbers. One function
   * a check, each returning the warnings it has; every threshold stands with its reason beside the check.
   * doc/warnings.md lists them for users.
   */
  using Warnings = std::vector<Warning>;

  inline void append(Warnings &all, const Warnings &more)
  {
    all.insert(all.end(), more.begin(), more.end());
  }

  /// Of the input, before anything is solved: what cancels, and overlap that linear elasticity cannot mean.
  Warnings input_warnings(const Scene &scene, const Model &model);

  /// Of one body's solution: strains that are not small, a stress that is infinite.
  Warnings body_warnings(const BodyResult &body);

  /// Of one pair's displacements: the sides slide too far, or off each other; contact that was missed.
  Warnings pair_warnings(const PairResult &pair);

  /// Of how far the bodies of a pair move without deforming.
  Warnings motion_warnings(const PairResult &pair);

  /// Of the pressures of one pair: the largest stands where an edge presses in.
  Warnings edge_warnings(const PairResult &pair, const std::vector<BodyResult> &bodies);

  /// Of the pressures of one surface (any of its pairs): too narrow for the mesh, or rough.
  Warnings pressure_warnings(const PairResult &pair);

  /// Of gaps that change within the cells that press: they are not resolved, or jump.
  Warnings gap_warnings(const Scene &scene, const Solution &solution);

  /// Of penalties that give way beside the bodies.
  Warnings penalty_warnings(const Scene &scene, const Solution &solution);

  /// Of a scene none of whose pairs carries a force.
  Warnings touch_warnings(const std::vector<PairResult> &pairs);

  /// Of bodies that overlap, as they are placed, where no pair joins them.
  Warnings placed_overlap_warnings(const Scene &scene, const Model &model);

  /// The same once displaced, of bodies that do not overlap before.
  Warnings displaced_overlap_warnings(const Scene &scene, const Model &model, const Solution &solution);

  /// Of a run that estimates nothing: whether its mesh is far too coarse. All processes have to call it.
  Warnings coarse_mesh_warnings(const Executor &executor, const Results &results);

  /// What `solution` says by itself: bodies, each where it lives, pairs and their pressures. All processes
  /// have to call it, as `all_warnings`.
  Warnings result_warnings(const Executor &executor, const Solution &solution);

  /// Of points that the scene names: the exact stress is infinite there. All processes have to call it, and
  /// the next one.
  Warnings output_point_warnings(const Model &model, const std::vector<PointResult> &points);
  /// Goal = stress at a place where the exact stress is infinite.
  Warnings goal_warnings(const Scene &scene, const Model &model);

  /// Parameters that the chosen scheme takes no notice of.
  Warnings scheme_warnings(const Scene &scene);

  /// Estimators that are far from the true error, or see a part of it.
  Warnings estimator_warnings(const Scene &scene, const Model &model);

  /// Of more processes than there are bodies.
  Warnings process_warnings(const Model &model);

  /// Everything that a run says. `dropped_loads`: see HeldMotions.
  Warnings all_warnings(const Scene &scene, const Model &model, const Results &results,
                        const std::vector<std::string> &dropped_loads);
} // namespace abut
