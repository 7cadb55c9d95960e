// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/results/error_budget.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  std::array<ErrorPart, 6> ErrorBudget::parts() const
  {
    return {{{"discretisation", discretisation.value_or(0.)},
             {"contact", contact.value_or(0.)},
             {"iteration", iteration.value_or(0.)},
             {"penalty", penalty.value_or(0.)},
             {"linear_algebra", linear_algebra.value_or(0.)},
             {"geometry", geometry.value_or(0.)}}};
  }

  std::optional<double> ErrorBudget::estimate() const
  {
    if (!discretisation)
      return {};
    double squares = 0.;
    for (const ErrorPart &part : parts())
      squares += part.error * part.error;
    return std::sqrt(squares);
  }

  std::optional<double> ErrorBudget::bound() const
  {
    if (!bounded_part)
      return {};
    return *bounded_part + penalty.value_or(0.) + linear_algebra.value_or(0.) + geometry.value_or(0.);
  }

  ErrorPart ErrorBudget::dominant() const
  {
    const auto all = parts();
    return *std::max_element(all.begin(), all.end(),
                             [](const ErrorPart &a, const ErrorPart &b) { return a.error < b.error; });
  }
} // namespace abut
