// SPDX-License-Identifier: LGPL-2.1-or-later
// The logarithm that loops over it can use.
#include <abut/base/vector_versions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace abut;

TEST(VectorLog, IsThatOfTheLibrary)
{
  // fdlibm: below one unit in the last place, and the library's own half a unit.
  constexpr double units = 2. * std::numeric_limits<double>::epsilon();
  for (int exponent = -1000; exponent <= 1000; exponent += 25)
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const double x = std::ldexp(1. + i / 1000., exponent);
      EXPECT_NEAR(vector_log(x), std::log(x), units * std::abs(std::log(x))) << x;
    }
}

TEST(VectorLog, KeepsRelativeAccuracyNearOne)
{
  constexpr double units = 2. * std::numeric_limits<double>::epsilon();
  EXPECT_EQ(vector_log(1.), 0.);
  for (double difference = .5; difference > 1e-15; difference *= .7)
    for (const double x : {1. + difference, 1. - difference})
      EXPECT_NEAR(vector_log(x), std::log(x), units * std::abs(std::log(x))) << x;
}
