// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/table.h>

#include <gtest/gtest.h>

namespace
{
  using abut::TextTable;
  using abut::without_empty_columns;

  TEST(BaseTable, LosesColumnsWithoutAnyNumber)
  {
    EXPECT_EQ(without_empty_columns({{"a", "b", "c"}, {"1", "-", "-"}, {"2", "-", "3"}}),
              (TextTable{{"a", "c"}, {"1", "-"}, {"2", "3"}}));
  }

  TEST(BaseTable, KeepsAMinusThatIsAHeading)
  {
    EXPECT_EQ(without_empty_columns({{"-", "b"}, {"1", "2"}}), (TextTable{{"-", "b"}, {"1", "2"}}));
  }
} // namespace
