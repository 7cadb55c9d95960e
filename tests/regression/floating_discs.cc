// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Discs that contact alone holds, against statics.
#include <gtest/gtest.h>

#include "program.h"
#include <cmath>
#include <iomanip>
#include <iostream>

using namespace abut::testing;

namespace
{
  double force_size(const Answer &answer, const std::string &name)
  {
    const auto force = contact(answer, name)["force"];
    const double size = std::hypot(force[0].get<double>(), force[1].get<double>());
    std::cout << name << ": force " << std::setprecision(16) << size << '\n';
    return size;
  }

  /// Area of the polygon that bilinear cells make of a unit disc, n edges to a quarter.
  double polygon_area(const unsigned int n)
  {
    return 2. * n * std::sin(std::acos(0.) / n);
  }
} // namespace

TEST(FloatingBodies, ADiscBetweenTwoPlates)
{
  const double weight = 2. * polygon_area(32);
  for (const std::string scheme : {"newton", "conjugate"})
  {
    const Answer answer = run_scene("disc-between-plates", {"Decomposition/Scheme=" + scheme});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const double below = contact(answer, "below")["force"][1], above = contact(answer, "above")["force"][1];
    std::cout << scheme << ": below, less above and the weight, by the weight "
              << (below + above) / weight + 1. << '\n';
    EXPECT_GT(above, 1.); // on the plates
    EXPECT_NEAR(below + above, -weight, 1e-9 * weight) << scheme;
    EXPECT_NEAR(contact(answer, "below")["force"][0].get<double>(), 0., 1e-9 * weight);
    expect_balance(answer);
  }
}

/// Nothing but the ends of the plates, far away and not the same on both sides, says where the disc is
/// sideways.
TEST(FloatingBodies, ADiscBesideTheMiddleOfItsPlates)
{
  for (const std::string scheme : {"newton", "conjugate"})
  {
    const Answer answer =
        run_scene("disc-between-plates",
                  {"Decomposition/Scheme=" + scheme, "Discretisation/Degree=2", "Body lower/Shift=-1.8, -2",
                   "Body lower/Cells=9, 3", "Body upper/Cells=14, 3", "Body disc/Cells=16, 6",
                   "Body disc/Body force=0, 0", "Output/Points=(0, 0)"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(warning_codes(answer).count("sideways-displacement"), 0u) << scheme;
    // Half of the approach, and sideways what the meshes are off from symmetry: the sides slide by 2e-3.
    const auto displacement = answer.summary["points"][0]["displacement"];
    EXPECT_NEAR(displacement[1].get<double>(), -.025, 2e-4) << scheme;
    EXPECT_LT(std::abs(displacement[0].get<double>()), 2e-4) << scheme;
    expect_balance(answer);
  }
}

TEST(FloatingBodies, ADiscInAGroove)
{
  const double weight = 3. * polygon_area(32);
  for (const std::string scheme : {"newton", "conjugate"})
  {
    const Answer answer = run_scene("v-groove", {"Decomposition/Scheme=" + scheme});
    ASSERT_EQ(answer.status, 0) << answer.err;
    for (const std::string side : {"left-flank", "right-flank"})
    {
      const double y = contact(answer, side)["force"][1];
      EXPECT_NEAR(force_size(answer, side), weight / std::sqrt(2.), 1e-8 * weight);
      EXPECT_NEAR(y, -.5 * weight, 1e-8 * weight);
    }
    expect_balance(answer);
    const auto steps = column(answer.directory + "/history.csv", "step");
    for (std::size_t i = 0; i < steps.size(); ++i)
      EXPECT_GE(steps[i], static_cast<double>(i + 1)); // each of them once
  }
}

namespace
{
  /// The pile with centres at 45 degrees, where a node of each disc looks at the other: statics of the round
  /// discs are those of the meshes too, as far as the discs are stiff.
  std::vector<std::string> pile_at_45_degrees(const std::string &modulus)
  {
    std::vector<std::string> overrides = {"Body left/Shift=-1.4142135623730951, 0",
                                          "Body right/Shift=1.4142135623730951, 0",
                                          "Body top/Shift=0, 1.4142135623730951",
                                          "Body left-wall/Shift=-3.4142135623730951, -1",
                                          "Body right-wall/Shift=2.4142135623730951, -1",
                                          "Body floor/Size=5, 1",
                                          "Body floor/Shift=-2.5, -2"};
    for (const std::string body : {"left", "right", "top", "floor", "left-wall", "right-wall"})
      overrides.push_back("Body " + body + "/Young modulus=" + modulus);
    return overrides;
  }
} // namespace

// Stiff discs touch at one node each: a wrong set of nodes lets them move far, and blocks of nodes never
// settle.
TEST(FloatingBodies, APileOfStiffDiscsIsThatOfStatics)
{
  const double weight = 3. * polygon_area(32);
  for (const std::string scheme : {"newton", "conjugate"})
    for (const std::string modulus : {"1e4", "5e4", "1e5", "1e7"})
    {
      std::vector<std::string> overrides = pile_at_45_degrees(modulus);
      overrides.push_back("Decomposition/Scheme=" + scheme);
      const Answer answer = run_scene("pile-of-discs", overrides);
      ASSERT_EQ(answer.status, 0) << scheme << ' ' << modulus << ": " << answer.err;
      EXPECT_LE(answer.summary["steps"].get<int>(), scheme == "newton" ? 30 : 1000) << modulus;
      for (const std::string side : {"left", "right"})
      {
        EXPECT_NEAR(force_size(answer, "top-on-" + side), weight / std::sqrt(2.), 1e-7 * weight);
        EXPECT_NEAR(force_size(answer, side + "-at-wall"), .5 * weight, 1e-7 * weight);
        EXPECT_NEAR(force_size(answer, side + "-on-floor"), 1.5 * weight, 1e-7 * weight);
      }
      expect_balance(answer);
    }
}

TEST(FloatingBodies, APileOfThreeDiscs)
{
  const double weight = 3. * polygon_area(32);
  const Answer answer = run_scene("pile-of-discs");
  ASSERT_EQ(answer.status, 0) << answer.err;
  // Which node of the discs touches is uncertain by an edge, 0.05: the angles of the forces, in statics too.
  for (const std::string side : {"left", "right"})
  {
    EXPECT_NEAR(force_size(answer, "top-on-" + side), .625 * weight, .02 * weight);
    EXPECT_NEAR(force_size(answer, side + "-at-wall"), .375 * weight, .02 * weight);
    EXPECT_NEAR(force_size(answer, side + "-on-floor"), 1.5 * weight, .02 * weight);
  }
  EXPECT_NEAR(contact(answer, "left-on-floor")["force"][1].get<double>() +
                  contact(answer, "right-on-floor")["force"][1].get<double>(),
              -3. * weight, 1e-9 * weight); // all that carries vertical loads is the straight floor
  expect_balance(answer);
}

// The nodes of a disc's side look away from its centre: its rotation changes no gap.
TEST(FloatingBodies, AMomentOnADiscIsRefused)
{
  expect_refused(run_scene("pile-of-discs", {"Body top/Body force=0.001*y, -3"}),
                 {"Body top", "rotation about (0, 1.6)", "no contact resists this motion"});
}
