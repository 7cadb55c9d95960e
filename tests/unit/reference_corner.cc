// SPDX-License-Identifier: LGPL-2.1-or-later
// The reentrant corner: Hooke's law and equilibrium by differences, free faces, exponent, symmetry.
#include <abut/base/user_error.h>
#include <abut/reference/reentrant_corner.h>

#include <boost/math/constants/constants.hpp>

#include "reference_fields_testing.h"
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    const ReentrantCorner corner(2.1e5, 0.3, 1.7);
  } // namespace

  TEST(ReentrantCorner, has_the_exponent_of_williams)
  {
    EXPECT_NEAR(corner.exponent(), 0.544483736782463929, 2e-15);
  }

  TEST(ReentrantCorner, is_elastic_and_in_equilibrium)
  {
    expect_elastic(
        corner, 2.1e5, 0.3,
        {Vector2(1., 0.2), Vector2(0.3, 1.), Vector2(-0.7, 0.9), Vector2(-1., -0.1), Vector2(-0.3, -0.8)},
        1e-3, 1e-7);
  }

  TEST(ReentrantCorner, has_free_faces)
  {
    for (const double r : {1e-6, 0.3, 2.})
    {
      const ExactStress right = corner.stress(Vector2(r, 0.));
      EXPECT_NEAR(right.yy / right.xx, 0., 1e-14);
      EXPECT_NEAR(right.xy / right.xx, 0., 1e-14);
      const ExactStress below = corner.stress(Vector2(0., -r));
      EXPECT_NEAR(below.xx / below.yy, 0., 1e-14);
      EXPECT_NEAR(below.xy / below.yy, 0., 1e-14);
    }
  }

  // The stress across the bisector is K r^(alpha-1), without shear.
  TEST(ReentrantCorner, has_the_stated_amplitude)
  {
    for (const double r : {1e-5, 1., 3.})
    {
      const Vector2 direction = Vector2(-1., 1.).normalized();
      const ExactStress s = corner.stress(r * direction);
      const double across = 0.5 * (s.xx + s.yy) + s.xy; // normal (1, 1)/sqrt(2)
      EXPECT_NEAR(across / (1.7 * std::pow(r, corner.exponent() - 1.)), 1., 1e-14);
      EXPECT_NEAR((s.yy - s.xx) / across, 0., 1e-14);
    }
  }

  // Mirror images in the bisector exchange the axes: (x, y) and (-y, -x).
  TEST(ReentrantCorner, is_symmetric_about_the_bisector)
  {
    for (const Vector2 &point : {Vector2(1., 0.), Vector2(0.4, 0.9), Vector2(-0.2, 0.8)})
    {
      const Vector2 mirror(-point.y(), -point.x());
      const Vector2 u = corner.displacement(point), v = corner.displacement(mirror);
      EXPECT_NEAR((v - Vector2(-u.y(), -u.x())).norm() / u.norm(), 0., 1e-14);
      const ExactStress s = corner.stress(point), t = corner.stress(mirror);
      EXPECT_NEAR(t.xx, s.yy, 1e-14);
      EXPECT_NEAR(t.yy, s.xx, 1e-14);
      EXPECT_NEAR(t.xy, s.xy, 1e-14);
    }
  }

  TEST(ReentrantCorner, is_homogeneous_in_the_distance)
  {
    const Vector2 point(-0.3, 0.5);
    for (const double factor : {1e-6, 7.})
    {
      const double growth = std::pow(factor, corner.exponent());
      EXPECT_NEAR(corner.stress(factor * point).xx / corner.stress(point).xx * factor / growth, 1., 1e-13);
      EXPECT_NEAR(corner.displacement(factor * point).x() / corner.displacement(point).x() / growth, 1.,
                  1e-13);
    }
    EXPECT_EQ(corner.displacement(Vector2::Zero()).norm(), 0.);
  }

  TEST(ReentrantCorner, refuses_data_that_make_no_sense)
  {
    EXPECT_THROW(ReentrantCorner(0., 0.3, 1.), UserError);
    EXPECT_THROW(ReentrantCorner(1., 0.5, 1.), UserError);
    EXPECT_THROW(ReentrantCorner(1., 0.3, std::numeric_limits<double>::infinity()), UserError);
  }
} // namespace abut
