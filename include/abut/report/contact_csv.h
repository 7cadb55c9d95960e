// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <string>

namespace abut
{
  /**
   * The content of contact_<pair>.csv: `x,y,arc_length,gap,pressure,length,load,load_x,load_y`, a row for
   * every part of the pair along the side that is cut (see Partition), places undeformed: the reported
   * pressure with its place, the mean gap, and the load p_k, which acts on the length at (load_x, load_y).
   */
  std::string contact_csv(const PairResult &result);
} // namespace abut
