// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement of a rigid side that carries a given force.
#include <abut/base/user_error.h>
#include <abut/decomposition/resultant_loading.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace abut;

namespace
{
  double find(const std::function<double(double)> &force, const double target, const double guess = 1.)
  {
    return find_rigid_displacement(force, target, guess, 1e-12, "Body b, side top");
  }

  /// Counts the evaluations: each is a contact problem of its own.
  struct Counted
  {
    std::function<double(double)> f;
    unsigned int n = 0;
    std::function<double(double)> function()
    {
      return [this](const double x) {
        ++n;
        return f(x);
      };
    }
  };
} // namespace

TEST(DecompositionResultant, LinearForceInOneSecant)
{
  Counted linear{[](const double x) { return 3. * x - 1.; }};
  EXPECT_NEAR(find(linear.function(), 5.), 2., 1e-12);
  EXPECT_LE(linear.n, 5u);
}

TEST(DecompositionResultant, SmoothForces)
{
  for (const double guess : {1e-4, 1., 5.})
  {
    Counted cubic{[](const double x) { return x + x * x * x; }};
    EXPECT_NEAR(find(cubic.function(), 10., guess), 2., 1e-11) << guess;
    EXPECT_LE(cubic.n, 60u) << guess;
    EXPECT_NEAR(find([](const double x) { return std::sinh(x); }, -3., guess), std::asinh(-3.), 1e-11)
        << guess;
  }
}

TEST(DecompositionResultant, ForceOfContactThatOpens)
{
  // Nothing until the gap of 0.3 is closed, then stiff.
  const auto kinked = [](const double x) { return std::max(0., 50. * (x - .3)); };
  for (const double guess : {.01, .3, 7.})
    EXPECT_NEAR(find(kinked, 4., guess), .38, 1e-12) << guess;
  const auto pressed_downwards = [](const double x) { return std::min(0., 50. * (x + .3)); };
  EXPECT_NEAR(find(pressed_downwards, -4.), -.38, 1e-12);
}

TEST(DecompositionResultant, ZeroTarget)
{
  EXPECT_EQ(find([](const double x) { return std::max(0., x); }, 0.), 0.);
  EXPECT_NEAR(find([](const double x) { return 2. * x + 3.; }, 0.), -1.5, 1e-11);
  EXPECT_NEAR(find([](const double x) { return 2. * x - 3.; }, 0.), 1.5, 1e-11);
}

TEST(DecompositionResultant, AForceNoDisplacementCarriesIsRefused)
{
  try
  {
    find([](const double x) { return std::max(0., x); }, -2.);
    FAIL();
  }
  catch (const ComputationError &error)
  {
    const std::string text = error.what();
    EXPECT_EQ(text.find("Body b, side top"), 0u) << text;
    EXPECT_NE(text.find("-2"), std::string::npos) << text;
  }
}

TEST(DecompositionResultant, AJumpAcrossTheTargetIsNoSolution)
{
  EXPECT_THROW(find([](const double x) { return x < .7 ? x : x + 10.; }, 5.), ComputationError);
}

TEST(DecompositionResultant, AForceThatIsNoNumberIsNoSolution)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find([nan](const double) { return nan; }, 5.), ComputationError);
  EXPECT_THROW(find([nan](const double x) { return x < .5 ? x : nan; }, 5.), ComputationError);
}
