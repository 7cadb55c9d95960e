// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/comparison/exact_solution.h>
#include <abut/results/estimator_quality.h>

namespace abut
{
  struct Estimation;
  struct PairResult;

  /// Empty where the solution does not know the response to the applied traction. Bodies are compared where
  /// they live: all processes have to call it.
  std::optional<EstimatorQuality> estimator_quality(const ExactSolution &exact, const Estimation &estimation,
                                                    const std::vector<BodyResult> &bodies,
                                                    const std::vector<PairResult> &pairs,
                                                    const Executor &executor);
} // namespace abut
