// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/contact_csv.h>
#include <abut/report/nodes_by_arc_length.h>
#include <abut/report/numbers.h>

#include <sstream>

namespace abut
{
  std::string contact_csv(const PairResult &result)
  {
    const Trace &slave = *result.slave;
    std::ostringstream out;
    out << "x,y,arc_length,gap,pressure\n";
    for (const std::size_t node : nodes_by_arc_length(slave))
    {
      const auto i = static_cast<Eigen::Index>(node);
      out << exact_number(slave.node_points()[node].x()) << ',' << exact_number(slave.node_points()[node].y())
          << ',' << exact_number(slave.node_arc_lengths()[node]) << ',' << exact_number(result.gaps[i]) << ','
          << exact_number(result.pressures[i]) << '\n';
    }
    return out.str();
  }
} // namespace abut
