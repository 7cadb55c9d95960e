// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_motions.h>
#include <abut/results/results.h>
#include <abut/run/model.h>

namespace abut
{
  /// What a solved interface means for the bodies: all but peaks and estimates. `motions`: those that the
  /// iteration has amplitudes of; null where it has none. Throws ComputationError.
  std::vector<BodyResult> body_results(const Model &model, const SchemeResult &iteration,
                                       double rigid_displacement, const InterfaceMotions *motions);

  /// And for the pairs. `bodies`: those of the same iteration.
  std::vector<PairResult> pair_results(const Model &model, const SchemeResult &iteration,
                                       const std::vector<BodyResult> &bodies);

  /// Adds what is asked of the last bodies alone: largest values, what was done with them and, where that is
  /// told, condition numbers. Throws ComputationError where the largest values or the energy are not finite.
  void add_final_values(const Executor &executor, bool tells_condition, std::vector<BodyResult> &bodies);
} // namespace abut
