// SPDX-License-Identifier: LGPL-2.1-or-later
// Each wave of the surface displacement against a Galerkin solution through the thickness of the layer.
#include <Eigen/Cholesky>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include "reference_layers_data.h"
#include <cmath>

namespace abut
{
  namespace
  {
    using ModesGauss = boost::math::quadrature::gauss<double, 60>;
    constexpr double pi = boost::math::constants::pi<double>();

    /**
     * Depth of the wave cos(lambda x) that the unit pressure wave leaves on the surface: the energy of
     * u = (U(y) sin lambda x, V(y) cos lambda x), V(0) = 0 and U(0) = 0 on a bonded base, is minimised over
     * polynomials.
     */
    double wave_compliance(const Layer &layer, double lambda)
    {
      const Eigen::Index n = 20;
      const double mu = layer.young_modulus / (2. * (1. + layer.poisson_ratio));
      const double first_lame = 2. * mu * layer.poisson_ratio / (1. - 2. * layer.poisson_ratio);
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
      const auto add_point = [&](double t, double weight) {
        Eigen::VectorXd xx = Eigen::VectorXd::Zero(2 * n), yy = xx, shear = xx;
        for (Eigen::Index k = 0; k < n; ++k)
        {
          const auto order = static_cast<unsigned int>(k);
          const double value = std::legendre(order, t);
          const double slope =
              (k == 0 ? 0. : double(k) * (std::legendre(order - 1, t) - t * value) / (1. - t * t)) * 2. /
              layer.thickness;
          const double y = 0.5 * (1. + t) * layer.thickness;
          const bool bonded = layer.base == Layer::Base::bonded; // U = y P_k, else P_k
          xx(k) = bonded ? lambda * y * value : lambda * value;
          shear(k) = bonded ? value + y * slope : slope;
          yy(n + k) = value + y * slope; // V = y P_k
          shear(n + k) = -lambda * y * value;
        }
        const Eigen::VectorXd sum = xx + yy;
        stiffness +=
            weight * (first_lame * sum * sum.transpose() +
                      2. * mu * (xx * xx.transpose() + yy * yy.transpose()) + mu * shear * shear.transpose());
      };
      for (std::size_t i = 0; i < ModesGauss::abscissa().size(); ++i)
        for (const double sign : {-1., 1.})
          add_point(sign * ModesGauss::abscissa()[i], 0.5 * layer.thickness * ModesGauss::weights()[i]);
      Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n);
      load.tail(n).setConstant(layer.thickness);
      return load.dot(stiffness.ldlt().solve(load));
    }

    // (2/length) int_0^length f cos(lambda x) dx for f with a kink of square-root kind at a.
    template <typename Function>
    double wave_amplitude(const Function &f, double lambda, double a, double length)
    {
      const auto wave = [&](double x) { return f(x) * std::cos(lambda * x); };
      const auto inside = [&](double s) { return wave(a * (1. - s * s)) * 2. * a * s; };
      const auto outside = [&](double s) { return wave(a + (length - a) * s * s) * 2. * (length - a) * s; };
      return 2. / length * (ModesGauss::integrate(inside, 0., 1.) + ModesGauss::integrate(outside, 0., 1.));
    }
  } // namespace

  TEST(LayersContact, every_wave_has_the_compliance_of_a_galerkin_solution)
  {
    for (const LayersContactData &data : {different_layers(), bonded_and_sliding_layers(), bonded_layers()})
    {
      const LayersContact exact(data);
      const double length = data.length;
      for (const unsigned int body : {0U, 1U})
        for (const int k : {1, 2, 3, 5, 8})
        {
          const double lambda = k * pi / length;
          const double pressed =
              wave_amplitude([&](double x) { return exact.pressure(x); }, lambda, exact.half_width(), length);
          const double moved = wave_amplitude([&](double x) { return exact.displacement(body, x); }, lambda,
                                              exact.half_width(), length);
          const double expected = pressed * wave_compliance(data.layers[body], lambda);
          EXPECT_NEAR((moved - expected) / exact.displacement(body, 0.), 0., 1e-12) << "wave " << k;
        }
    }
  }

  // A wave much longer than the layer is thick, near lambda = 0 in a layer without ends.
  TEST(Layer, infinite_ends_are_the_limit_of_long_waves)
  {
    for (const Layer::Base base : {Layer::Base::sliding, Layer::Base::bonded})
    {
      const Layer layer{0.7e5, 0.42, 1.7, base};
      const double limit = wave_compliance(layer, 1e-3);
      EXPECT_NEAR(layer.uniform_compliance(Layer::Ends::infinite) / limit, 1., 2e-5);
      EXPECT_NEAR(layer.half_plane_compliance() * (1. + layer.compliance_change(1e-3 * layer.thickness)) /
                      (1e-3 * limit),
                  1., 1e-9);
    }
  }

  TEST(LayersContact, uniform_pressure_compresses_without_lateral_strain)
  {
    const LayersContact exact(bonded_and_sliding_layers());
    const double length = exact.data().length;
    for (const unsigned int body : {0U, 1U})
    {
      const Layer &layer = exact.data().layers[body];
      const double nu = layer.poisson_ratio;
      const double modulus = layer.young_modulus * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
      const double mean = 0.5 * wave_amplitude([&](double x) { return exact.displacement(body, x); }, 0.,
                                               exact.half_width(), length);
      EXPECT_NEAR(mean / (exact.force() / length * layer.thickness / modulus), 1., 1e-12);
    }
  }
} // namespace abut
