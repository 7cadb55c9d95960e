// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/results/step_estimate.h>

#include <string>
#include <vector>

namespace abut
{
  /// The content of history.csv: a row for every step of the decomposition, its pass beside it.
  class History
  {
  public:
    /// A new mesh; `counts`: of all bodies together.
    void begin_pass(const unsigned int pass, const Counts &counts)
    {
      pass_ = pass;
      counts_ = counts;
    }
    /// `wall_time`: seconds since the run began.
    void add(const StepRecord &record, const double wall_time)
    {
      rows_.push_back({pass_, counts_, record, wall_time, {}, {}});
    }
    /// Belongs to the last step.
    void add(const StepEstimate &estimate) { rows_.back().estimate = estimate; }
    /// What the pass has found stands in its last row.
    void end_pass(const PassRecord &record);

    void serialize(Archive &archive) { archive(pass_, counts_, rows_); }

    /// Header and rows. Cells are empty where nothing was estimated or known; `error_iteration` is the
    /// guaranteed bound of the state that the step began with.
    std::string csv() const;

  private:
    struct Row
    {
      unsigned int pass;
      Counts counts;
      StepRecord step;
      double wall_time;
      std::optional<StepEstimate> estimate;
      std::optional<PassRecord> found;

      void serialize(Archive &archive) { archive(pass, counts, step, wall_time, estimate, found); }
    };
    static std::vector<std::string> cells(const Row &row);

    unsigned int pass_ = 0;
    Counts counts_;
    std::vector<Row> rows_;
  };
} // namespace abut
