// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/reference/exact_stress.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace abut
{
  /// d/dx and d/dy of f by differences of the fourth order.
  template <typename Function> auto gradient(const Function &f, const Vector2 &point, double h)
  {
    using Value = decltype(f(point));
    const auto along = [&](const Vector2 &step) -> Value {
      const Value near = f(point + step) - f(point - step);
      const Value far = f(point + 2. * step) - f(point - 2. * step);
      return (8. * near - far) / (12. * h);
    };
    return std::array<Value, 2>{{along(Vector2(h, 0.)), along(Vector2(0., h))}};
  }

  /// The field obeys Hooke's law of plane strain and is in equilibrium at the points, up to `tolerance` times
  /// the largest stress there; h is the step of the differences.
  template <typename Field>
  void expect_elastic(const Field &field, double young_modulus, double poisson_ratio,
                      const std::vector<Vector2> &points, double h, double tolerance)
  {
    const double mu = young_modulus / (2. * (1. + poisson_ratio));
    const double lame = 2. * mu * poisson_ratio / (1. - 2. * poisson_ratio);
    for (const Vector2 &point : points)
    {
      const ExactStress s = field.stress(point);
      const double scale = std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.xy)});
      const auto u = [&](const Vector2 &x) { return field.displacement(x); };
      const auto [u_x, u_y] = gradient(u, point, h);
      const double dilatation = u_x.x() + u_y.y();
      EXPECT_NEAR((2. * mu * u_x.x() + lame * dilatation - s.xx) / scale, 0., tolerance) << point.transpose();
      EXPECT_NEAR((2. * mu * u_y.y() + lame * dilatation - s.yy) / scale, 0., tolerance) << point.transpose();
      EXPECT_NEAR((mu * (u_x.y() + u_y.x()) - s.xy) / scale, 0., tolerance) << point.transpose();
      EXPECT_NEAR((lame * dilatation - s.zz) / scale, 0., tolerance) << point.transpose();
      const auto tensor = [&](const Vector2 &x) {
        const ExactStress t = field.stress(x);
        return Eigen::Vector3d(t.xx, t.yy, t.xy);
      };
      const auto [s_x, s_y] = gradient(tensor, point, h);
      EXPECT_NEAR((s_x(0) + s_y(2)) / scale, 0., tolerance) << point.transpose();
      EXPECT_NEAR((s_x(2) + s_y(1)) / scale, 0., tolerance) << point.transpose();
    }
  }
} // namespace abut
