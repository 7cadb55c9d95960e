// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/error_budget.h>
#include <abut/results/estimation.h>
#include <abut/results/results.h>
#include <abut/run/setup.h>

namespace abut
{
  /// The parts of a solution's error but for the penalty's, which the interface solver knows.
  ErrorBudget error_budget(const Setup &setup, const Estimation &estimation, const Solution &solution);
} // namespace abut
