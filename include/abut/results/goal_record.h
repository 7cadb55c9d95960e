// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <optional>

namespace abut
{
  /// The quantity that a Tolerance belongs to, where it is not the energy norm. Errors are relative.
  struct GoalRecord
  {
    double value = 0.; ///< force, pressure or stress
    /// Estimated by the changes from mesh to mesh: 1.5 times the largest of the last one, half of that before
    /// and a quarter of that before it. Empty before the third mesh.
    std::optional<double> discretisation;
    std::optional<double> penalty; ///< first terms of its expansion; empty for stresses

    std::optional<double> total() const
    {
      return discretisation ? std::optional<double>(*discretisation + penalty.value_or(0.)) : std::nullopt;
    }

    void serialize(Archive &archive) { archive(value, discretisation, penalty); }
  };
} // namespace abut
