// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/interface_solver.h>
#include <abut/results/results.h>

namespace abut
{
  /// How far a solution is from the limit of the iteration, which is found by going on: for one that the
  /// increment rule has stopped and a dense compliance. Empty else, or where that takes too long.
  std::optional<LimitDistance> limit_distance(const InterfaceProblem &problem, const InterfaceSolver &solver,
                                              const Solution &solution);
} // namespace abut
