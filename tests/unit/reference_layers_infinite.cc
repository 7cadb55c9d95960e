// SPDX-License-Identifier: LGPL-2.1-or-later
// Layers without ends: figures known to ten digits, the integral over the line, the far field.
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>

namespace abut
{
  namespace
  {
    void expect_ratio(double value, double expected, double tolerance)
    {
      EXPECT_NEAR(value / expected, 1., tolerance);
    }

    // L(u) as printed, for u below 300.
    double printed_compliance(const Layer &layer, double u)
    {
      if (layer.base == Layer::Base::sliding)
        return (std::cosh(2. * u) - 1.) / (std::sinh(2. * u) + 2. * u);
      const double kappa = 3. - 4. * layer.poisson_ratio;
      return (2. * kappa * std::sinh(2. * u) - 4. * u) /
             (2. * kappa * std::cosh(2. * u) + 1. + kappa * kappa + 4. * u * u);
    }

    /**
     * (2(1-nu^2)/(pi E)) int_{-a}^{a} p(s) k((x - s)/H) ds with k(t) = int_0^inf L(u) cos(ut)/u du. Of L the
     * part 1 - exp(-u) is integrated in closed form, ln(1 + 1/t^2)/2, the rest by Gauss.
     */
    double line_displacement(const LayersContact &exact, const Layer &layer, double x)
    {
      using Gauss = boost::math::quadrature::gauss<double, 30>;
      const double a = exact.half_width();
      const double H = layer.thickness;
      const double pi = boost::math::constants::pi<double>();
      const auto rest = [&](double u) {
        const auto wave = [&](double angle) {
          const double s = a * std::sin(angle);
          return exact.pressure(s) * std::cos(u * s / H) * a * std::cos(angle);
        };
        double transform = 0.;
        for (int i = 0; i < 4; ++i)
          transform += Gauss::integrate(wave, i * pi / 8., (i + 1) * pi / 8.);
        return 2. * transform * (printed_compliance(layer, u) - 1. + std::exp(-u)) / u * std::cos(u * x / H);
      };
      double sum = 0.;
      for (int i = 0; i < 80; ++i)
        sum += Gauss::integrate(rest, 0.5 * i, 0.5 * (i + 1));

      boost::math::quadrature::tanh_sinh<double> quadrature;
      const auto logarithm = [&](double distance, double s) {
        return exact.pressure(s) * std::log(std::hypot(H, distance) / distance);
      };
      sum += quadrature.integrate([&](double t) { return logarithm(t, x - t); }, 0., x + a);
      sum += quadrature.integrate([&](double t) { return logarithm(t, x + t); }, 0., a - x);
      return layer.half_plane_compliance() / pi * sum;
    }
  } // namespace

  // Figures of a solution by integrals over the line instead of series, known to ten digits.
  TEST(LayersContact, reproduces_the_known_figures_of_infinite_layers)
  {
    const LayersContact sliding(infinite_layers(Layer::Base::sliding));
    expect_ratio(sliding.half_width(), 0.992642040657, 1e-10);
    expect_ratio(sliding.pressure(0.), 166.202449905, 1e-10);
    expect_ratio(sliding.force(), 126.573908875, 1e-10);
    const LayersContact bonded(infinite_layers(Layer::Base::bonded));
    expect_ratio(bonded.half_width(), 1.025218454690, 1e-10);
    expect_ratio(bonded.pressure(0.), 193.527416749, 1e-10);
    expect_ratio(bonded.force(), 150.320235035, 1e-10);
  }

  // A uniform pressure between rollers and one on an infinite bonded layer are the same thing.
  TEST(LayersContact, long_bonded_layers_do_not_feel_their_ends)
  {
    LayersContactData data = bonded_layers();
    data.length = 23.;
    const LayersContact rollers(data);
    data.ends = Layer::Ends::infinite;
    const LayersContact infinite(data);
    EXPECT_GT(infinite.data().length, 25.);
    expect_ratio(infinite.half_width(), rollers.half_width(), 1e-12);
    expect_ratio(infinite.force(), rollers.force(), 1e-12);
    for (const unsigned int body : {0U, 1U})
    {
      const Vector2 point(1.1, 0.7);
      expect_ratio(infinite.stress(body, point).yy, rollers.stress(body, point).yy, 1e-11);
      expect_ratio(infinite.stress(body, point).xx, rollers.stress(body, point).xx, 1e-11);
      expect_ratio(infinite.displacement(body, 0.9), rollers.displacement(body, 0.9), 1e-11);
      expect_ratio(infinite.stress_l2_norm(body), rollers.stress_l2_norm(body), 1e-12);
    }
  }

  // Ends that are free let go what rollers hold: nothing is left far from the contact.
  TEST(LayersContact, infinite_layers_are_at_rest_far_from_the_contact)
  {
    for (const Layer::Base base : {Layer::Base::sliding, Layer::Base::bonded})
    {
      const LayersContact exact(infinite_layers(base));
      const double scale = exact.pressure(0.);
      for (const double y : {0., 0.5, 1.})
      {
        const ExactStress s = exact.stress(0, Vector2(18., y));
        EXPECT_NEAR(s.xx / scale, 0., 1e-5);
        EXPECT_NEAR(s.yy / scale, 0., 1e-5);
        EXPECT_NEAR(s.xy / scale, 0., 1e-5);
      }
      EXPECT_NEAR(exact.displacement(0, 18.) / exact.displacement(0, 0.), 0., 1e-5);
    }
  }

  TEST(LayersContact, infinite_layers_give_way_as_the_integral_over_the_line_says)
  {
    LayersContactData data = bonded_and_sliding_layers();
    data.ends = Layer::Ends::infinite;
    const LayersContact exact(data);
    for (const unsigned int body : {0U, 1U})
      for (const double t : {0.1, 0.5, 0.9})
      {
        const double x = t * exact.half_width();
        expect_ratio(exact.displacement(body, x), line_displacement(exact, data.layers[body], x), 1e-11);
      }
  }
} // namespace abut
