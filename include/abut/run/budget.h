// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/error_budget.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>

namespace abut
{
  /// The parts of a solution's error. `penalty_energy`: squared energy norm of what a penalty changes; empty
  /// where that is not known, or no error.
  ErrorBudget error_budget(const Solution &solution, const Estimation &estimation,
                           const std::optional<double> &penalty_energy);
} // namespace abut
