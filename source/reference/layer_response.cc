// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/layer_response.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr double response_pi = boost::math::constants::pi<double>();

    // xx^2 + yy^2 + zz^2 + 2 xy^2 of a wave, integrated over the scaled height 0 <= v <= u of the layer.
    double integrate_wave_square(const Layer &layer, const double u)
    {
      const AiryWave wave = layer.wave(u);
      const auto square = [&](double v) {
        const WaveStress s = wave.stress(v, u);
        const double zz = layer.poisson_ratio * (s.xx + s.yy);
        return s.xx * s.xx + s.yy * s.yy + zz * zz + 2. * s.xy * s.xy;
      };
      const int n_panels = 1 + static_cast<int>(u / 5.);
      double sum = 0.;
      for (int panel = 0; panel < n_panels; ++panel)
        sum += boost::math::quadrature::gauss<double, 30>::integrate(square, u * panel / n_panels,
                                                                     u * (panel + 1) / n_panels);
      return sum;
    }

    AiryWave scaled(const AiryWave &wave, const double factor)
    {
      return {factor * wave.rising, factor * wave.rising_slope, factor * wave.falling,
              factor * wave.falling_slope};
    }
  } // namespace

  LayerResponse::LayerResponse(const Layer &layer, std::shared_ptr<const PeriodicPressure> pressure,
                               const Layer::Ends ends)
      : layer_(layer), pressure_(std::move(pressure)), ends_(ends)
  {
    Assert(pressure_ != nullptr, dealii::ExcMessage("a layer answers a pressure"));
    layer_.check("The layer");
    const double length = pressure_->length();
    modes_ = pressure_->modes(layer_.n_thin_modes(length));
    Assert(modes_.allFinite(), dealii::ExcMessage("a pressure has finite amplitudes"));
    for (Eigen::Index k = 1; k < modes_.size(); ++k)
      changes_.push_back(
          scaled(layer_.wave_change(double(k) * response_pi * layer_.thickness / length), modes_(k)));
  }

  double LayerResponse::displacement(const double x) const
  {
    const Eigen::VectorXd potential = Eigen::VectorXd::Constant(1, pressure_->potential(x));
    const Eigen::VectorXd point = Eigen::VectorXd::Constant(1, x);
    return layer_.uniform_compliance(ends_) * modes_(0) +
           layer_.wave_displacement(pressure_->length(), point, modes_, potential)(0, 0);
  }

  double LayerResponse::strain_energy() const
  {
    return 0.5 * pressure_->integrate_against([&](double x) { return displacement(x); });
  }

  // The waves are powers of three numbers: no exponential per wave.
  ExactStress LayerResponse::face_stress(const double x, const double height) const
  {
    const double first = response_pi / pressure_->length();
    const double rise = std::exp(first * (height - layer_.thickness));
    const double fall = std::exp(-first * (height + layer_.thickness));
    const double cosine = std::cos(first * x);
    const double sine = std::sin(first * x);
    double exp_rising = 1., exp_falling = 1., cosine_k = 1., sine_k = 0., v = 0.;
    ExactStress sum;
    for (const AiryWave &change : changes_)
    {
      v += first * height;
      exp_rising *= rise;
      exp_falling *= fall;
      const double next_cosine = cosine_k * cosine - sine_k * sine;
      sine_k = sine_k * cosine + cosine_k * sine;
      cosine_k = next_cosine;
      const WaveStress wave = change.stress(v, exp_rising, exp_falling);
      sum.xx += wave.xx * cosine_k;
      sum.yy += wave.yy * cosine_k;
      sum.xy += wave.xy * sine_k;
    }
    sum.xx += (1. - layer_.uniform_stress_ratio(ends_)) * modes_(0);
    return sum;
  }

  ExactStress LayerResponse::stress(const Vector2 &point) const
  {
    Assert(point.allFinite(), dealii::ExcMessage("a point is finite"));
    const double height = std::min(point.y(), layer_.thickness);
    const double depth = layer_.thickness - height;
    const PeriodicPressure::Potential g = pressure_->complex_potential(point.x(), depth);
    ExactStress result = face_stress(point.x(), height);
    result.xx -= g.value.real() - depth * g.slope.imag();
    result.yy -= g.value.real() + depth * g.slope.imag();
    result.xy -= depth * g.slope.real();
    result.zz = layer_.poisson_ratio * (result.xx + result.yy);
    return result;
  }

  std::vector<ExactStress> LayerResponse::stress(const std::vector<Vector2> &points) const
  {
    std::vector<ExactStress> result;
    result.reserve(points.size());
    for (const Vector2 &point : points)
      result.push_back(stress(point));
    return result;
  }

  // A wave of a half-plane has the square integral (2 + 2 nu^2)/lambda over the depth; sum_k p_k^2/lambda_k
  // is 2/l times the integral of p against its potential.
  double LayerResponse::stress_l2_norm() const
  {
    const double nu = layer_.poisson_ratio;
    const double length = pressure_->length();
    const double ratio = layer_.uniform_stress_ratio(ends_);
    const double axial = nu * (1. + ratio);
    const double half_plane = 2. + 2. * nu * nu;
    double sum = half_plane * pressure_->integrate_against([&](double x) { return pressure_->potential(x); });
    sum += length * layer_.thickness * modes_(0) * modes_(0) * (1. + ratio * ratio + axial * axial);
    for (Eigen::Index k = 1; k < modes_.size(); ++k)
    {
      const double lambda = double(k) * response_pi / length;
      const double change = integrate_wave_square(layer_, lambda * layer_.thickness) - half_plane;
      sum += 0.5 * length * modes_(k) * modes_(k) * change / lambda;
    }
    return std::sqrt(sum);
  }
} // namespace abut
