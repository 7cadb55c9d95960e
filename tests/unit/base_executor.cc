// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/executor.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
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
    for_each(4, [&](const std::size_t a) { for_each(8, [&](const std::size_t) { sum += 1u << (4 * a); }); });
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
      for_each(3, fail_at_second);
      FAIL() << "nothing was thrown";
    }
    catch (const std::out_of_range &error)
    {
      EXPECT_STREQ(error.what(), "turn 1");
    }
  }

  TEST(Executor, PassesOnTheExceptionOfTheLowestTurn)
  {
    // Also where a later turn fails before it.
    const auto fail = [](const std::size_t a) {
      if (a == 1)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (a % 2 == 1)
        throw std::out_of_range("turn " + std::to_string(a));
    };
    for (int repetition = 0; repetition < 20; ++repetition)
      try
      {
        for_each(8, fail);
        FAIL() << "nothing was thrown";
      }
      catch (const std::out_of_range &error)
      {
        EXPECT_STREQ(error.what(), "turn 1");
      }
  }

  TEST(Executor, KeepsTheResultsOfBodiesInTheirOrder)
  {
    const std::vector<std::string> names =
        Executor().of_bodies(12, [](const std::size_t a) { return std::to_string(a); });
    ASSERT_EQ(names.size(), 12u);
    for (std::size_t a = 0; a < names.size(); ++a)
      EXPECT_EQ(names[a], std::to_string(a));
  }

  TEST(Executor, GivesWhatTheFirstProcessHas)
  {
    unsigned int n_calls = 0;
    const std::string word = Executor().from_first([&]() {
      ++n_calls;
      return std::string("word");
    });
    EXPECT_EQ(word, "word");
    EXPECT_EQ(n_calls, 1u);
    EXPECT_THROW(Executor().from_first([]() -> int { throw std::runtime_error("none"); }),
                 std::runtime_error);
  }

  using Homes = std::vector<Ranks>;

  TEST(Executor, SharesBodiesByTheirCosts)
  {
    const std::vector<BodyLoad> equal(5, {1.});
    // 5 + 2 + 1 and 4 + 3: the dearest first, each where there is the least to do.
    EXPECT_EQ(least_loaded({{1.}, {2.}, {5.}, {4.}, {3.}}, {}, 2), (Homes{{0}, {0}, {0}, {1}, {1}}));
    EXPECT_EQ(least_loaded(equal, {}, 3), (Homes{{0}, {1}, {2}, {0}, {1}}));
    EXPECT_EQ(least_loaded(equal, {}, 1), (Homes{{0}, {0}, {0}, {0}, {0}}));
    EXPECT_EQ(least_loaded({{2.}, {1.}}, {}, 4), (Homes{{0}, {1}}));
    // Those that stay are a load already.
    EXPECT_EQ(least_loaded({{3., true}, {1.}, {1.}}, {{1}, {0}, {1}}, 2), (Homes{{1}, {0}, {0}}));
  }

  TEST(Executor, GivesABodySeveralProcesses)
  {
    // 6 by three of four processes are 2 in each, less than 3 in the other one.
    EXPECT_EQ(least_loaded({{6., false, 3}, {1.}, {3.}}, {}, 4), (Homes{{1, 2, 3}, {1}, {0}}));
    EXPECT_EQ(least_loaded({{6., false, 4}, {1.}}, {}, 4), (Homes{{0, 1, 2, 3}, {0}}));
    // One that stays is a load in all of its processes.
    EXPECT_EQ(least_loaded({{6., true, 2}, {1.}}, {{0, 2}, {}}, 3), (Homes{{0, 2}, {1}}));
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
