// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/trace.h>

#include <vector>

namespace abut
{
  /// The nodes of a side in the order of their arc lengths.
  std::vector<std::size_t> nodes_by_arc_length(const Trace &side);
} // namespace abut
