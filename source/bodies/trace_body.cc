// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/trace_body.h>

namespace abut
{
  Eigen::Index TraceBody::trace_offset(const std::size_t side) const
  {
    std::size_t n_nodes = 0;
    for (std::size_t i = 0; i < side; ++i)
      n_nodes += contact_sides()[i].n_nodes();
    return static_cast<Eigen::Index>(2 * n_nodes);
  }
} // namespace abut
