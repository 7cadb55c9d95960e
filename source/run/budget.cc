// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/run/budget.h>

#include <cmath>

namespace abut
{
  ErrorBudget error_budget(const Setup & /*setup*/, const Estimation &estimation, const Solution &solution)
  {
    ErrorBudget budget;
    budget.discretisation = estimation.discretisation();
    budget.contact = estimation.contact();
    budget.bounded_part = estimation.bound();
    if (std::isfinite(solution.iteration.iteration_error))
      budget.iteration = solution.iteration.iteration_error;
    return budget;
  }
} // namespace abut
