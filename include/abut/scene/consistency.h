// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/scene.h>

namespace abut
{
  /// Throws UserError for sections that do not fit together: pairs of unknown bodies, twice the same pair,
  /// loads beside a resultant, an estimator that is missing or cannot do what is asked.
  void check_consistency(const Scene &scene);
} // namespace abut
