// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/displacement_entries.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  void add_displacement(const Eigen::Index row, const double factor, const Segment &segment,
                        const Eigen::VectorXd &values, const Vector2 &direction,
                        std::vector<Eigen::Triplet<double>> &entries)
  {
    AssertDimension(values.size(), static_cast<Eigen::Index>(segment.nodes.size()));
    for (std::size_t j = 0; j < segment.nodes.size(); ++j)
      for (int component = 0; component < 2; ++component)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(2 * segment.nodes[j]) + component,
                             factor * values[static_cast<Eigen::Index>(j)] * direction[component]);
  }
} // namespace abut
