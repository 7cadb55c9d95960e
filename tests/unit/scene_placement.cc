// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/placement.h>

#include <gtest/gtest.h>

#include <cmath>

using abut::Placement;
using abut::Vector2;

TEST(Placement, quarter_turns_are_exact)
{
  const Vector2 a(3., 1.);
  const auto turned = [&](const double angle) {
    return Placement(1., false, angle, {0., 0.}).point_to_world(a);
  };
  EXPECT_EQ(turned(90.), Vector2(-1., 3.));
  EXPECT_EQ(turned(180.), Vector2(-3., -1.));
  EXPECT_EQ(turned(270.), Vector2(1., -3.));
  EXPECT_EQ(turned(-90.), Vector2(1., -3.));
  EXPECT_EQ(turned(-180.), Vector2(-3., -1.));
  EXPECT_EQ(turned(3690.), Vector2(-1., 3.));
}

TEST(Placement, other_angles_turn_counter_clockwise)
{
  for (const double angle : {30., 130., -37., 44., 46., 301.})
  {
    const double radians = angle * std::acos(-1.) / 180.;
    const Vector2 image = Placement(1., false, angle, {0., 0.}).direction_to_world({1., 0.});
    EXPECT_NEAR(image.x(), std::cos(radians), 1e-15) << angle;
    EXPECT_NEAR(image.y(), std::sin(radians), 1e-15) << angle;
  }
}

TEST(Placement, scales_then_mirrors_then_turns_then_shifts)
{
  const Placement placement(2., true, 90., {10., 20.});
  // (3, 1) -> (6, 2) -> (-6, 2) -> (-2, -6) -> (8, 14)
  EXPECT_EQ(placement.point_to_world({3., 1.}), Vector2(8., 14.));
  EXPECT_EQ(placement.direction_to_world({3., 1.}), Vector2(-1., -3.));
  EXPECT_EQ(placement.length_to_world(3.), 6.);
  EXPECT_TRUE(placement.is_mirrored());
}

TEST(Placement, world_to_own_undoes_own_to_world)
{
  const Vector2 own(0.7, -1.3);
  for (const bool mirrored : {false, true})
  {
    const Placement placement(0.01, mirrored, 37., {-5., 2.});
    EXPECT_LT((placement.point_to_own(placement.point_to_world(own)) - own).norm(), 1e-13);
  }
}
