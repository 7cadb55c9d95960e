// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <nlohmann/json_fwd.hpp>

namespace abut
{
  /**
   * The content of summary.json. Every key is there; what was not estimated or does not apply is null, as is
   * what is not finite. Errors are relative; forces, stresses and lengths are in the user's units, times in
   * seconds, memory in MiB.
   */
  nlohmann::ordered_json summary(const Results &results, double total_seconds);

  /// The word for it in summary.json.
  std::string to_string(StoppedBy reason);
} // namespace abut
