// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress field of two layers: the equations of plane strain and every boundary condition, by means that
// share nothing with the way it is computed.
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    using Gauss = boost::math::quadrature::gauss<double, 30>;

    template <typename Function> double integrate_panels(const Function &f, double from, double to, int n)
    {
      double sum = 0.;
      for (int i = 0; i < n; ++i)
        sum += Gauss::integrate(f, from + (to - from) * i / n, from + (to - from) * (i + 1) / n);
      return sum;
    }

    // Fourth-order central difference.
    template <typename Function> double derivative(const Function &f, double h)
    {
      return (8. * (f(h) - f(-h)) - f(2. * h) + f(-2. * h)) / (12. * h);
    }

    double strain(const Layer &layer, double along, double across, double axial)
    {
      return (along - layer.poisson_ratio * (across + axial)) / layer.young_modulus;
    }
  } // namespace

  using LayersStressCase = std::pair<LayersContactData (*)(), unsigned int>; // layers and body

  struct LayersStress : testing::TestWithParam<LayersStressCase>
  {
    const LayersContact exact{GetParam().first()};
    const unsigned int body = GetParam().second;
    const Layer &layer = exact.data().layers[body];
    const double length = exact.data().length;
    const double H = layer.thickness;
    const double scale = exact.pressure(0.);

    ExactStress at(double x, double y) const { return exact.stress(body, Vector2(x, y)); }

    /// Zero where the rigid face holds the layer: the shear stress, or the strain along the face in stress.
    double held_at_face(double x) const
    {
      const ExactStress s = at(x, 0.);
      return layer.base == Layer::Base::sliding ? s.xy
                                                : layer.young_modulus * strain(layer, s.xx, s.yy, s.zz);
    }
  };

  TEST_P(LayersStress, is_in_equilibrium)
  {
    const double h = 1e-3;
    for (const Vector2 &point :
         {Vector2(0.31, 0.1), Vector2(0.9, 0.8), Vector2(1.5, 0.55), Vector2(2.8, 0.93)})
    {
      const double x = point.x();
      const double y = point.y() * H;
      const double in_x = derivative([&](double t) { return at(x + t, y).xx; }, h) +
                          derivative([&](double t) { return at(x, y + t).xy; }, h);
      const double in_y = derivative([&](double t) { return at(x + t, y).xy; }, h) +
                          derivative([&](double t) { return at(x, y + t).yy; }, h);
      EXPECT_NEAR(in_x / scale, 0., 1e-7) << "at " << point.transpose();
      EXPECT_NEAR(in_y / scale, 0., 1e-7) << "at " << point.transpose();
    }
  }

  // Strains come from a displacement where xx + yy is harmonic.
  TEST_P(LayersStress, is_compatible)
  {
    const double h = 1e-2;
    for (const Vector2 &point :
         {Vector2(0.31, 0.1), Vector2(0.9, 0.7), Vector2(1.5, 0.55), Vector2(2.8, 0.9)})
    {
      const auto sum = [&](double dx, double dy) {
        const ExactStress s = at(point.x() + dx, point.y() * H + dy);
        return s.xx + s.yy;
      };
      const auto second = [&](double dx, double dy) {
        return (16. * (sum(dx, dy) + sum(-dx, -dy)) - sum(2. * dx, 2. * dy) - sum(-2. * dx, -2. * dy) -
                30. * sum(0., 0.)) /
               (12. * h * h);
      };
      EXPECT_NEAR((second(h, 0.) + second(0., h)) / scale, 0., 1e-5) << "at " << point.transpose();
    }
  }

  TEST_P(LayersStress, meets_the_boundary_conditions)
  {
    for (const double t : {0.03, 0.21, 0.4, 0.63, 0.88, 1.})
    {
      const double x = t * length;
      EXPECT_NEAR(held_at_face(x) / scale, 0., 1e-13) << "rigid face, x = " << x;
      EXPECT_NEAR(at(x, H).xy / scale, 0., 1e-13) << "contact face, x = " << x;
      EXPECT_NEAR((at(x, H).yy + exact.pressure(x)) / scale, 0., 1e-12) << "x = " << x;
      EXPECT_NEAR((at(x, H * (1. - 1e-9)).yy + exact.pressure(x)) / scale, 0., 1e-7) << "x = " << x;
      EXPECT_NEAR(at(0., t * H).xy / scale, 0., 1e-13) << "roller at x = 0, y/H = " << t;
      EXPECT_NEAR(at(length, t * H).xy / scale, 0., 1e-13) << "roller at x = length, y/H = " << t;
      EXPECT_NEAR(at(-x, 0.9 * H).yy / at(x, 0.9 * H).yy, 1., 1e-12) << "mirror image, x = " << x;
    }
    const ExactStress edge = at(exact.half_width(), H);
    EXPECT_TRUE(std::isfinite(edge.xx + edge.yy + edge.xy));
  }

  // Nothing moves through the rollers: the lateral strain has no sum along x at any height.
  TEST_P(LayersStress, leaves_the_length_between_the_rollers)
  {
    for (const double t : {0., 0.3, 0.8})
    {
      const double growth = integrate_panels(
          [&](double x) {
            const ExactStress s = at(x, t * H);
            return strain(layer, s.xx, s.yy, s.zz);
          },
          0., length, 20);
      EXPECT_NEAR(growth * layer.young_modulus / (scale * length), 0., 1e-12);
    }
  }

  TEST_P(LayersStress, shortens_the_layer_by_the_displacement_of_its_surface)
  {
    for (const double x : {0., 0.37, 0.8, 0.7 * length, length})
    {
      const double shortening = -integrate_panels(
          [&](double y) {
            const ExactStress s = at(x, y);
            return strain(layer, s.yy, s.xx, s.zz);
          },
          0., H, 20);
      EXPECT_NEAR(shortening / exact.displacement(body, 0.),
                  exact.displacement(body, x) / exact.displacement(body, 0.), 1e-11)
          << "x = " << x;
    }
  }

  TEST_P(LayersStress, carries_the_force_at_every_height)
  {
    for (const double t : {0., 0.4, 0.9})
      EXPECT_NEAR(integrate_panels([&](double x) { return at(x, t * H).yy; }, 0., length, 20) / exact.force(),
                  -1., 1e-12);
  }

  // Integrated over the layer: the norm, and the energy from stresses instead of from pressure and
  // displacement.
  TEST_P(LayersStress, has_the_stated_norm_and_energy)
  {
    double square = 0.;
    double energy = 0.;
    const double a = exact.half_width();
    const auto add_strip = [&](double from, double to) {
      const auto along = [&](double y, auto density) {
        return integrate_panels([&](double x) { return density(at(x, y)); }, from, to, 4);
      };
      // depth d = H s^3 gathers points under the edge of contact
      const auto over_depth = [&](auto density) {
        return integrate_panels(
            [&](double s) { return 3. * H * s * s * along(H * (1. - s * s * s), density); }, 0., 1., 2);
      };
      square += over_depth(
          [](const ExactStress &s) { return s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2. * s.xy * s.xy; });
      energy += over_depth([&](const ExactStress &s) {
        return 0.5 * (s.xx * strain(layer, s.xx, s.yy, s.zz) + s.yy * strain(layer, s.yy, s.xx, s.zz) +
                      2. * (1. + layer.poisson_ratio) / layer.young_modulus * s.xy * s.xy);
      });
    };
    add_strip(0., a);
    add_strip(a, length);
    EXPECT_NEAR(std::sqrt(square) / exact.stress_l2_norm(body), 1., 1e-6);
    EXPECT_NEAR(energy / exact.strain_energy(body), 1., 1e-6);
  }

  INSTANTIATE_TEST_SUITE_P(both_bodies, LayersStress,
                           testing::Values(LayersStressCase{different_layers, 0U},
                                           LayersStressCase{different_layers, 1U},
                                           LayersStressCase{bonded_and_sliding_layers, 0U},
                                           LayersStressCase{bonded_and_sliding_layers, 1U},
                                           LayersStressCase{bonded_layers, 0U},
                                           LayersStressCase{bonded_layers, 1U}));
} // namespace abut
