// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/numbers.h>
#include <abut/report/progress.h>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr std::chrono::milliseconds shortest_pause(100);

    /// 1, 2 or 5 times a power of ten.
    bool is_round(unsigned int step)
    {
      while (step > 0 && step % 10 == 0)
        step /= 10;
      return step == 1 || step == 2 || step == 5;
    }

    std::string progress_text(const StepRecord &record)
    {
      // Columns of fixed width, so that a line wholly covers the one before.
      std::ostringstream out;
      out << "step " << std::setw(6) << record.step << "  increment " << std::setw(11)
          << short_number(record.increment) << "  error bound " << std::setw(11) << short_number(record.bound)
          << "  largest load " << std::setw(11) << short_number(record.max_pressure);
      return out.str();
    }

    std::string percentage(const double share)
    {
      return short_number(100. * share, 3) + " %";
    }

    /// What a pass says of its error, and where that comes from.
    std::string error_text(const Scene &scene, const PassRecord &record)
    {
      const std::string asked = "; asked for: " + percentage(scene.tolerance);
      if (record.goal)
      {
        const std::optional<double> error = record.goal->total();
        return scene.goal.text() + " " + short_number(record.goal->value, 7) + ", error " +
               (error ? "about " + percentage(*error) : "not known before the third mesh") + asked;
      }
      const ErrorPart part = record.budget.dominant();
      return std::string("error ") + (record.error_is_bound() ? "at most " : "about ") +
             (record.total ? percentage(*record.total) : "unknown") + " (" + record.estimator +
             "), most of it " + part.name + ", " + percentage(part.error) +
             (record.pressure ? "; of the pressures about " + percentage(*record.pressure) : "") + asked;
    }
  } // namespace

  ProgressLine::ProgressLine(std::ostream &out, const bool terminal, const bool quiet)
      : out_(out), terminal_(terminal), quiet_(quiet)
  {}

  void ProgressLine::begin_pass(const unsigned int pass, const Counts &counts)
  {
    if (quiet_ || pass == 0)
      return;
    finish();
    out_ << "pass " << pass << ": " << counts.cells << " cells, " << counts.dofs << " unknowns" << std::endl;
  }

  void ProgressLine::step(const StepRecord &record)
  {
    if (quiet_)
      return;
    if (is_due(record))
      show(record);
    else
      waiting_ = record;
  }

  void ProgressLine::end_pass(const Scene &scene, const PassRecord &record)
  {
    if (quiet_ || !scene.has_tolerance())
      return;
    finish();
    out_ << "  " << error_text(scene, record) << std::endl;
  }

  void ProgressLine::finish()
  {
    if (waiting_)
      show(*waiting_);
    waiting_.reset();
    if (line_is_open_)
      out_ << std::endl;
    line_is_open_ = false;
  }

  bool ProgressLine::is_due(const StepRecord &record) const
  {
    if (!terminal_)
      return is_round(record.step);
    return !line_is_open_ || std::chrono::steady_clock::now() - last_shown_ >= shortest_pause;
  }

  void ProgressLine::show(const StepRecord &record)
  {
    if (terminal_)
      out_ << '\r' << progress_text(record) << std::flush;
    else
      out_ << progress_text(record) << std::endl;
    line_is_open_ = terminal_;
    last_shown_ = std::chrono::steady_clock::now();
    waiting_.reset();
  }
} // namespace abut
