// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts in contact that follow one another.
#include <abut/trace/contact_runs.h>

#include <gtest/gtest.h>

#include <string>

using namespace abut;

namespace
{
  /// Of a stretch of parts from 3 on: those of the text that are `x` press.
  std::vector<ContactRun> runs(const std::string &parts, const bool closed)
  {
    constexpr std::size_t first = 3;
    return contact_runs({first, first + parts.size(), closed, 0.},
                        [&](const std::size_t k) { return parts.at(k - first) == 'x'; });
  }
} // namespace

TEST(ContactRuns, AreThePartsBetweenThoseThatDoNotPress)
{
  EXPECT_EQ(runs(".xx..x.", false), (std::vector<ContactRun>{{4, 5}, {8}}));
  EXPECT_EQ(runs("xx.x", false), (std::vector<ContactRun>{{3, 4}, {6}}));
  EXPECT_TRUE(runs("....", false).empty());
  EXPECT_TRUE(runs("....", true).empty());
}

TEST(ContactRuns, GoOverTheStartOfAClosedStretch)
{
  EXPECT_EQ(runs("xx.x", true), (std::vector<ContactRun>{{6, 3, 4}}));
  EXPECT_EQ(runs("x..xx.x", true), (std::vector<ContactRun>{{6, 7}, {9, 3}}));
}

TEST(ContactRuns, MayBeTheWholeStretch)
{
  for (const bool closed : {false, true})
  {
    const std::vector<ContactRun> all = runs("xxx", closed);
    ASSERT_EQ(all, (std::vector<ContactRun>{{3, 4, 5}}));
    EXPECT_TRUE(fills(all[0], {3, 6, closed, 0.}));
    EXPECT_FALSE(fills(all[0], {3, 7, closed, 0.}));
  }
}
