// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

using namespace abut;

namespace
{
  TEST(Executor, EveryTurnRunsOnce)
  {
    for (const std::size_t n : {0u, 1u, 3u, 1000u})
    {
      std::vector<unsigned int> turns(n, 0);
      for_each(n, [&](const std::size_t i) { ++turns[i]; });
      EXPECT_EQ(turns, std::vector<unsigned int>(n, 1)) << n;
    }
  }

  TEST(Executor, LoopsStandWithinEachOther)
  {
    std::atomic<unsigned int> sum{0};
    for_each_body(
        4, [&](const std::size_t a) { for_each(8, [&](const std::size_t) { sum += 1u << (4 * a); }); });
    EXPECT_EQ(sum, 0x8888u);
  }

  TEST(Executor, PassesOnAnException)
  {
    const auto fail_at_second = [](const std::size_t a) {
      if (a == 1)
        throw std::out_of_range("turn " + std::to_string(a));
    };
    try
    {
      for_each_body(3, fail_at_second);
      FAIL() << "nothing was thrown";
    }
    catch (const std::out_of_range &error)
    {
      EXPECT_STREQ(error.what(), "turn 1");
    }
  }

  TEST(Executor, RunsOnAfterAnException)
  {
    EXPECT_THROW(for_each(100, [](const std::size_t) { throw std::runtime_error("all"); }),
                 std::runtime_error);
    std::atomic<unsigned int> n{0};
    for_each(100, [&](const std::size_t) { ++n; });
    EXPECT_EQ(n, 100u);
  }
} // namespace
