// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/layers_sliding.h>
#include <abut/reference/layers_sliding_solve.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double layers_pi = boost::math::constants::pi<double>();

    // xx^2 + yy^2 + zz^2 + 2 xy^2 of a wave, integrated over the scaled height 0 <= v <= u of the layer.
    double integrate_wave_square(const double u, const double poisson_ratio)
    {
      const auto square = [&](double v) {
        const WaveStress s = layer_wave(u, v);
        const double zz = poisson_ratio * (s.xx + s.yy);
        return s.xx * s.xx + s.yy * s.yy + zz * zz + 2. * s.xy * s.xy;
      };
      const int n_panels = 1 + static_cast<int>(u / 5.);
      double sum = 0.;
      for (int panel = 0; panel < n_panels; ++panel)
        sum += boost::math::quadrature::gauss<double, 30>::integrate(square, u * panel / n_panels,
                                                                     u * (panel + 1) / n_panels);
      return sum;
    }

    // Stress that the rigid face and the missing lateral strain add to that of the half-plane.
    ExactStress layer_correction(const Layer &layer, const Eigen::VectorXd &modes, const double length,
                                 const double x, const double height)
    {
      const double ratio = layer.poisson_ratio / (1. - layer.poisson_ratio);
      ExactStress sum;
      sum.xx = (1. - ratio) * modes(0);
      for (Eigen::Index k = 1; k < modes.size(); ++k)
      {
        const double lambda = double(k) * layers_pi / length;
        const WaveStress wave = layer_wave(lambda * layer.thickness, lambda * height);
        const WaveStress deep = half_plane_wave(lambda * (layer.thickness - height));
        const double cosine = modes(k) * std::cos(lambda * x);
        sum.xx += (wave.xx - deep.xx) * cosine;
        sum.yy += (wave.yy - deep.yy) * cosine;
        sum.xy += (wave.xy - deep.xy) * modes(k) * std::sin(lambda * x);
      }
      return sum;
    }
  } // namespace

  LayersSliding::LayersSliding(const LayersSlidingData &data)
      : data_(data), pressure_(solve_layers_sliding(data)),
        modes_{{pressure_.modes(data.layers[0].n_thin_modes(data.length)),
                pressure_.modes(data.layers[1].n_thin_modes(data.length))}}
  {}

  double LayersSliding::displacement(const unsigned int body, const double x) const
  {
    const Layer &layer = data_.layers.at(body);
    const Eigen::VectorXd &modes = modes_.at(body);
    const Eigen::VectorXd potential = Eigen::VectorXd::Constant(1, pressure_.potential(x));
    return layer.uniform_compliance() * modes(0) +
           wave_displacement(layer, data_.length, Eigen::VectorXd::Constant(1, x), modes, potential)(0, 0);
  }

  double LayersSliding::strain_energy(const unsigned int body) const
  {
    return 0.5 * pressure_.integrate_against([&](double x) { return displacement(body, x); });
  }

  // With G of ContactPressure and the depth d the half-plane has yy = -(Re G + d Im G'),
  // xx = -(Re G - d Im G'), xy = -d Re G'.
  ExactStress LayersSliding::stress(const unsigned int body, const Vector2 &point) const
  {
    const Layer &layer = data_.layers.at(body);
    const double height = std::min(point.y(), layer.thickness);
    const double depth = layer.thickness - height;
    const ContactPressure::Potential g = pressure_.complex_potential(point.x(), depth);
    ExactStress result = layer_correction(layer, modes_.at(body), data_.length, point.x(), height);
    result.xx -= g.value.real() - depth * g.slope.imag();
    result.yy -= g.value.real() + depth * g.slope.imag();
    result.xy -= depth * g.slope.real();
    result.zz = layer.poisson_ratio * (result.xx + result.yy);
    return result;
  }

  std::vector<ExactStress> LayersSliding::stress(const unsigned int body,
                                                 const std::vector<Vector2> &points) const
  {
    std::vector<ExactStress> result;
    result.reserve(points.size());
    for (const Vector2 &point : points)
      result.push_back(stress(body, point));
    return result;
  }

  // A wave of a half-plane has the square integral (2 + 2 nu^2)/lambda over the depth; sum_k p_k^2/lambda_k
  // is 2/l times the integral of p against its potential.
  double LayersSliding::stress_l2_norm(const unsigned int body) const
  {
    const Layer &layer = data_.layers.at(body);
    const Eigen::VectorXd &modes = modes_.at(body);
    const double nu = layer.poisson_ratio;
    const double ratio = nu / (1. - nu);
    const double half_plane = 2. + 2. * nu * nu;
    double sum = half_plane * pressure_.integrate_against([&](double x) { return pressure_.potential(x); });
    sum += data_.length * layer.thickness * modes(0) * modes(0) * (1. + ratio * ratio * 2.);
    for (Eigen::Index k = 1; k < modes.size(); ++k)
    {
      const double lambda = double(k) * layers_pi / data_.length;
      const double change = integrate_wave_square(lambda * layer.thickness, nu) - half_plane;
      sum += 0.5 * data_.length * modes(k) * modes(k) * change / lambda;
    }
    return std::sqrt(sum);
  }
} // namespace abut
