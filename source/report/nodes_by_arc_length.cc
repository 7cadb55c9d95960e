// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/nodes_by_arc_length.h>

#include <algorithm>
#include <numeric>

namespace abut
{
  std::vector<std::size_t> nodes_by_arc_length(const Trace &side)
  {
    std::vector<std::size_t> order(side.n_nodes());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
      return side.node_arc_lengths()[a] < side.node_arc_lengths()[b];
    });
    return order;
  }
} // namespace abut
