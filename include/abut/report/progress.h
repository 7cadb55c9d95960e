// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/counts.h>
#include <abut/decomposition/scheme.h>
#include <abut/results/results.h>

#include <chrono>
#include <iosfwd>
#include <optional>

namespace abut
{
  /**
   * One line that tells how the steps go. On a terminal it is rewritten in place, at most ten times a second;
   * elsewhere only the steps 1, 2, 5, 10, 20, 50, ... get a line each. The last step is always shown. Quiet:
   * nothing at all. The `largest load` of a line is that of a part of the interface, which is not yet a
   * reported pressure (the `peak pressure` of the tables).
   */
  class ProgressLine
  {
  public:
    /// `out` must outlive the object.
    ProgressLine(std::ostream &out, bool terminal, bool quiet);

    /// Ends the line of the pass before and, from the second pass on, names the new mesh.
    void begin_pass(unsigned int pass, const Counts &counts);
    void step(const StepRecord &record);
    /// One line on the error of a pass, where the scene has a tolerance.
    void end_pass(const Scene &scene, const PassRecord &record);
    /// Shows the last step if it is not there yet, and ends the line.
    void finish();

  private:
    bool is_due(const StepRecord &record) const;
    void show(const StepRecord &record);

    std::ostream &out_;
    bool terminal_, quiet_;
    std::optional<StepRecord> waiting_; ///< the last step, while not shown
    bool line_is_open_ = false;
    std::chrono::steady_clock::time_point last_shown_;
  };
} // namespace abut
