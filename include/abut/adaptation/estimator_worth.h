// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/adaptation_parameters.h>

namespace abut
{
  /// Estimated by true error in the energy norm.
  struct EstimatorWorth
  {
    double least, most;
    /// More than twice too small or too large.
    bool is_rough() const { return least < .5 || most > 2.; }
  };

  /**
   * The range that an estimator has had with elements of a degree on scenes with exact solutions: layers in
   * contact, sliding and bonded, flat punch, re-entrant corner (`EstimatorWorth` in
   * tests/convergence/estimator_worth.cc measures it). Empty for none, for fe-be, which has a bound, and
   * above degree 3.
   */
  std::optional<EstimatorWorth> estimator_worth(EstimatorKind kind, unsigned int degree);
} // namespace abut
