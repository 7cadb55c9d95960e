// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/hertz.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>

namespace abut
{
  TEST(HertzLineContact, pressure_carries_the_force)
  {
    const HertzLineContact hertz(12.5, 3.7, 1.1e5);
    const double a = hertz.half_width();
    const auto transformed = [&](double s) { return hertz.pressure(a * std::sin(s)) * a * std::cos(s); };
    const double quarter = boost::math::constants::half_pi<double>();
    const double force =
        boost::math::quadrature::gauss<double, 30>::integrate(transformed, -quarter, quarter);
    EXPECT_NEAR(force / 12.5, 1., 1e-12);
    EXPECT_EQ(hertz.pressure(1.01 * a), 0.);
  }

  TEST(HertzLineContact, peak_is_the_root_of_force_times_modulus_by_pi_radius)
  {
    const HertzLineContact hertz(12.5, 3.7, 1.1e5);
    const double pi = boost::math::constants::pi<double>();
    EXPECT_NEAR(hertz.max_pressure() / std::sqrt(12.5 * 1.1e5 / (pi * 3.7)), 1., 1e-14);
    EXPECT_DOUBLE_EQ(hertz.pressure(0.), hertz.max_pressure());
  }

  namespace
  {
    /**
     * What rigid faces and rollers add to the kernel of two half-planes is, near the contact, a constant plus
     * this number times the square of the distance.
     */
    double kernel_curvature(const LayersContactData &data)
    {
      const double pi = boost::math::constants::pi<double>();
      double sum = 0.;
      for (const Layer &layer : data.layers)
      {
        const double E = layer.young_modulus / (1. - layer.poisson_ratio * layer.poisson_ratio);
        double waves = 0.;
        for (int k = 1; k <= 100; ++k)
        {
          const double u = k * pi * layer.thickness / data.length;
          waves += u * ((std::cosh(2. * u) - 1.) / (std::sinh(2. * u) + 2. * u) - 1.) / layer.thickness;
        }
        sum += 2. / E * (pi / (24. * data.length * data.length) - waves / (2. * data.length));
      }
      return sum;
    }
  } // namespace

  // Layers thicker than the contact act as half-planes under a gap (r0 + curvature * force) x^2, of the
  // radius 1/(2 (r0 + ...)), up to terms of the fourth order in the contact width.
  TEST(HertzLineContact, is_the_limit_of_thick_layers)
  {
    double last_error = 1.;
    for (const double approach : {4e-4, 1e-4, 2.5e-5})
    {
      LayersContactData data = different_layers();
      data.approach = approach;
      const LayersContact layers(data);
      const Layer &first = data.layers[0];
      const Layer &second = data.layers[1];
      const double modulus = composite_modulus(first.young_modulus, first.poisson_ratio, second.young_modulus,
                                               second.poisson_ratio);
      const double force = 2. * layers.force();
      const double curvature = data.gap_curvature + kernel_curvature(data) * force;
      const HertzLineContact hertz(force, 1. / (2. * curvature), modulus);
      const double error = std::abs(layers.half_width() / hertz.half_width() - 1.);
      EXPECT_LT(error, std::pow(layers.half_width(), 4));
      EXPECT_LT(error, last_error / 15.);
      last_error = error;
    }
  }

  TEST(HertzLineContact, refuses_what_does_not_touch)
  {
    EXPECT_THROW(HertzLineContact(0., 1., 1.), UserError);
    EXPECT_THROW(HertzLineContact(1., -1., 1.), UserError);
    EXPECT_THROW(HertzLineContact(1., 1., 0.), UserError);
  }
} // namespace abut
