// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/registry.h>

#include <Eigen/Core>

namespace abut
{
  struct AdaptationParameters;
  struct CellErrors;
  struct CellMarks;

  /// What stands behind a word of `Marking`. Each way has its own in source/adaptation/.
  struct MarkingEntry
  {
    static constexpr const char *parameter = "Marking";

    std::string name, documentation;
    /// See `mark`.
    CellMarks (*mark)(const CellErrors &errors, const Eigen::VectorXd &eta,
                      const AdaptationParameters &parameters) = nullptr;
    bool needs_limit = false;     ///< splits the cells above Limit, which then is above 0
    bool needs_tolerance = false; ///< chooses among the cells of all bodies, see goal_marks: `mark` is null
  };
} // namespace abut
