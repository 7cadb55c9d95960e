// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

namespace abut
{
  /// Adds the time until its end of life to a number of seconds.
  class Stopwatch
  {
  public:
    explicit Stopwatch(double &seconds) : seconds_(seconds) {}
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch &) = delete;
    Stopwatch &operator=(const Stopwatch &) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double &seconds_;
    Clock::time_point start_ = Clock::now();
  };
} // namespace abut
