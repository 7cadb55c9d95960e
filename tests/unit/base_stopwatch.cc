// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/stopwatch.h>

#include <gtest/gtest.h>

#include <thread>

using namespace abut;

namespace
{
  constexpr double nap = .02; // seconds; sleeps may last longer, never shorter

  void sleep()
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(nap));
  }

  TEST(Stopwatch, AddsItsLifeToWhatIsThere)
  {
    double seconds = 100.;
    const WallClock clock;
    {
      const Stopwatch watch(seconds);
      sleep();
    }
    EXPECT_GE(seconds, 100. + nap);
    EXPECT_LE(seconds, 100. + clock.seconds());
  }

  TEST(Stopwatch, StandsStillWhileAnInnerOneRuns)
  {
    double outer = 0., inner = 0., innermost = 0.;
    const WallClock clock;
    {
      Stopwatch watch(outer);
      sleep();
      for (unsigned int i = 0; i < 2; ++i)
      {
        Stopwatch inner_watch(inner, watch);
        sleep();
        const Stopwatch innermost_watch(innermost, inner_watch);
        sleep();
        sleep();
      }
      sleep();
    }
    EXPECT_GE(outer, 2. * nap);
    EXPECT_GE(inner, 2. * nap);
    EXPECT_GE(innermost, 4. * nap);
    // Every second counts once. Had one counted twice, the sum would exceed the time that has passed.
    EXPECT_LE(outer + inner + innermost, clock.seconds());
  }

  TEST(WallClock, GoesOnFromTheSecondsOfBefore)
  {
    const WallClock other;
    WallClock clock;
    clock.add(100.);
    clock.add(20.);
    const double seconds = clock.seconds();
    EXPECT_GE(seconds, 120.);
    EXPECT_LE(seconds, 120. + other.seconds());
  }
} // namespace
