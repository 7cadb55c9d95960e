// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

namespace abut
{
  /// Wall-clock time since it was made.
  class WallClock
  {
  public:
    double seconds() const { return before_ + std::chrono::duration<double>(Clock::now() - start_).count(); }
    /// Counts seconds that went by before it was made.
    void add(const double seconds) { before_ += seconds; }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    double before_ = 0.;
  };

  /**
   * Adds the wall-clock seconds of its life to a number, e.g. a member of Times, which names what they were
   * spent on. Within another stopwatch it stops the outer one meanwhile, so that the same second never counts
   * twice.
   */
  class Stopwatch
  {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds) {}
    /// The outer one must outlive this one, and run.
    Stopwatch(double &seconds, Stopwatch &outer) : seconds_(seconds), outer_(&outer) { outer_->stop(); }
    ~Stopwatch()
    {
      stop();
      if (outer_ != nullptr)
        outer_->clock_ = WallClock();
    }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    void stop() { seconds_ += clock_.seconds(); }

    double &seconds_;
    Stopwatch *outer_ = nullptr;
    WallClock clock_; ///< since it was made or has gone on
  };
} // namespace abut
