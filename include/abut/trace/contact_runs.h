// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/partition.h>

#include <functional>
#include <vector>

namespace abut
{
  /// Parts in contact that follow one another, in the direction of the surface.
  using ContactRun = std::vector<std::size_t>;

  /**
   * Those of a stretch, as long as they can be. In a closed stretch one may go over its start; where all of
   * it is in contact there is one run, of all parts, which has no ends.
   */
  std::vector<ContactRun> contact_runs(const Stretch &stretch,
                                       const std::function<bool(std::size_t part)> &presses);

  /// Whether the run is all of its stretch, so that sides and not pressures say where contact ends.
  inline bool fills(const ContactRun &run, const Stretch &stretch)
  {
    return run.size() == stretch.last - stretch.first;
  }
} // namespace abut
