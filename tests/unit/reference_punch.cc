// SPDX-License-Identifier: LGPL-2.1-or-later
// The flat punch: Hooke's law and equilibrium by differences, the boundary, the edge, the far field.
#include <abut/base/user_error.h>
#include <abut/reference/flat_punch.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include "reference_fields_testing.h"
#include <cmath>
#include <vector>

namespace abut
{
  namespace
  {
    const FlatPunchData punch_data{2.1e5, 0.3, 0.7, 12.5};
    const double punch_pi = boost::math::constants::pi<double>();
  } // namespace

  TEST(FlatPunch, is_elastic_and_in_equilibrium)
  {
    const FlatPunch punch(punch_data);
    expect_elastic(
        punch, punch_data.young_modulus, punch_data.poisson_ratio,
        {Vector2(0., -0.5), Vector2(0.5, -0.1), Vector2(-0.8, -0.3), Vector2(1.5, -0.1), Vector2(0.7, -2.)},
        1e-3, 1e-7);
  }

  TEST(FlatPunch, meets_the_conditions_on_the_surface)
  {
    const FlatPunch punch(punch_data);
    const double a = punch_data.half_width;
    const double scale = punch.displacement(Vector2(10., 0.)).y();
    for (const double x : {0., 0.1, -0.3, 0.6, 0.699999})
    {
      EXPECT_NEAR(punch.displacement(Vector2(x, 0.)).y() / scale, 0., 1e-14) << x;
      const ExactStress s = punch.stress(Vector2(x, 0.));
      EXPECT_NEAR(-s.yy / (12.5 / (punch_pi * std::sqrt(a * a - x * x))), 1., 1e-9) << x;
      EXPECT_NEAR(punch.pressure(x) / -s.yy, 1., 1e-12) << x;
      EXPECT_EQ(s.xy, 0.) << x;
    }
    for (const double x : {0.700001, 0.8, -1.3, 40.})
    {
      const ExactStress s = punch.stress(Vector2(x, 0.));
      EXPECT_NEAR(s.yy, 0., 1e-13 * std::abs(s.xx) + 1e-15) << x;
      EXPECT_EQ(s.xy, 0.) << x;
      EXPECT_EQ(punch.pressure(x), 0.) << x;
      EXPECT_GT(punch.displacement(Vector2(x, 0.)).y(), 0.) << x;
    }
  }

  TEST(FlatPunch, is_symmetric_and_measured_from_the_punch)
  {
    const FlatPunch punch(punch_data);
    const double scale = punch.displacement(Vector2(10., 0.)).y();
    EXPECT_NEAR(punch.displacement(Vector2(0., 0.)).norm() / scale, 0., 1e-14);
    for (const Vector2 &point : {Vector2(0.3, 0.), Vector2(0.7, -0.4), Vector2(3., -0.1)})
    {
      const Vector2 mirror(-point.x(), point.y());
      const Vector2 u = punch.displacement(point), v = punch.displacement(mirror);
      EXPECT_NEAR(v.x() / u.x(), -1., 1e-12);
      EXPECT_NEAR(v.y(), u.y(), 1e-12 * u.norm());
      EXPECT_NEAR(punch.stress(mirror).yy / punch.stress(point).yy, 1., 1e-12);
      EXPECT_NEAR(punch.stress(mirror).xy, -punch.stress(point).xy, 1e-15);
    }
  }

  // p = P/(pi sqrt(2 a r)) at the small distance r from the edge, along any path of the angle 0 or pi.
  TEST(FlatPunch, is_singular_at_its_edges)
  {
    const FlatPunch punch(punch_data);
    const double a = punch_data.half_width;
    for (const double r : {1e-6, 1e-8})
    {
      const double leading = punch_data.force / (punch_pi * std::sqrt(2. * a * r));
      EXPECT_NEAR(punch.pressure(a - r) / leading, 1., 2. * r / a);
      EXPECT_NEAR(punch.stress(Vector2(r - a, 0.)).yy / -leading, 1., 2. * r / a);
    }
  }

  // Far away the punch is a line force: sigma_r = -2 P cos(angle)/(pi r) and nothing else.
  TEST(FlatPunch, is_a_line_force_from_far_away)
  {
    const FlatPunch punch(punch_data);
    const double r = 1e4 * punch_data.half_width;
    for (const double angle : {-1.2, -0.4, 0., 0.9})
    {
      const Vector2 direction(std::sin(angle), -std::cos(angle));
      const double radial = -2. * punch_data.force * std::cos(angle) / (punch_pi * r);
      const ExactStress s = punch.stress(r * direction);
      EXPECT_NEAR(s.xx / radial, direction.x() * direction.x(), 1e-7);
      EXPECT_NEAR(s.yy / radial, direction.y() * direction.y(), 1e-7);
      EXPECT_NEAR(s.xy / radial, direction.x() * direction.y(), 1e-7);
    }
  }

  TEST(FlatPunch, carries_its_force_through_every_half_circle)
  {
    const FlatPunch punch(punch_data);
    for (const double r : {0.9, 5.})
    {
      const auto traction = [&](double angle) {
        const Vector2 normal(std::cos(angle), std::sin(angle));
        const ExactStress s = punch.stress(r * normal);
        return r * (s.xy * normal.x() + s.yy * normal.y());
      };
      double sum = 0.;
      for (int i = 0; i < 20; ++i)
        sum += boost::math::quadrature::gauss<double, 30>::integrate(traction, -punch_pi * (i + 1) / 20.,
                                                                     -punch_pi * i / 20.);
      EXPECT_NEAR(sum / punch_data.force, 1., 1e-11) << r;
    }
  }

  TEST(FlatPunch, refuses_what_is_no_punch)
  {
    EXPECT_THROW(FlatPunch({0., 0.3, 1., 1.}), UserError);
    EXPECT_THROW(FlatPunch({1., 0.5, 1., 1.}), UserError);
    EXPECT_THROW(FlatPunch({1., 0.3, 0., 1.}), UserError);
    EXPECT_THROW(FlatPunch({1., 0.3, 1., -1.}), UserError);
  }
} // namespace abut
