// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    CellMarks mark_above_limit(const CellErrors & /*errors*/, const Eigen::VectorXd &eta,
                               const AdaptationParameters &parameters)
    {
      CellMarks marks;
      for (const double error : eta)
      {
        marks.refine.push_back(error > std::max(parameters.limit, round_off_eta));
        marks.coarsen.push_back(error < parameters.coarsening * parameters.limit);
      }
      return marks;
    }

    const Registered<MarkingEntry> registered_threshold(
        {"threshold", "cells with eta above Limit; those below Coarsening times Limit may be merged",
         mark_above_limit, true});
  } // namespace
} // namespace abut
