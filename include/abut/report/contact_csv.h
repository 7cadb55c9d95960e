// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/results.h>

#include <string>

namespace abut
{
  /**
   * The content of contact_<pair>.csv: `x,y,arc_length,gap,pressure`, a row for every node of the slave side
   * by its arc length, places undeformed. The gap is empty where nothing faces the node.
   */
  std::string contact_csv(const PairResult &result);
} // namespace abut
