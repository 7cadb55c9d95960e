// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/decomposition/scheme.h>
#include <abut/report/counts.h>

#include <string>
#include <vector>

namespace abut
{
  /// The content of history.csv: a row for every step of the decomposition.
  class History
  {
  public:
    /// `counts`: of all bodies together.
    explicit History(const Counts &counts) : counts_(counts) {}

    /// `wall_time`: seconds since the run began.
    void add(const StepRecord &record, double wall_time) { rows_.push_back({record, wall_time}); }

    /// Header and rows. Cells are empty where nothing was estimated; `error_iteration` is the guaranteed
    /// bound of the state that the step began with; the pass of a uniform mesh is 0.
    std::string csv() const;

  private:
    struct Row
    {
      StepRecord record;
      double wall_time;
    };

    Counts counts_;
    std::vector<Row> rows_;
  };
} // namespace abut
