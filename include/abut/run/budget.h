// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/penalty_sensitivity.h>
#include <abut/results/error_budget.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>

namespace abut
{
  /// The parts of a solution's error. `penalty`: what it changes; empty where that is not known, or no
  /// error.
  ErrorBudget error_budget(const Executor &executor, const Solution &solution, const Estimation &estimation,
                           const std::optional<PenaltyChange> &penalty);
} // namespace abut
