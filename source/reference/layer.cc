// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/layer.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double layer_pi = boost::math::constants::pi<double>();
  } // namespace

  double Layer::half_plane_compliance() const
  {
    return 2. * (1. - poisson_ratio * poisson_ratio) / young_modulus;
  }

  bool Layer::strains_laterally(const Ends ends) const
  {
    return ends == Ends::infinite && base == Base::sliding;
  }

  double Layer::uniform_compliance(const Ends ends) const
  {
    if (strains_laterally(ends))
      return 0.5 * thickness * half_plane_compliance();
    return thickness * (1. + poisson_ratio) * (1. - 2. * poisson_ratio) /
           (young_modulus * (1. - poisson_ratio));
  }

  double Layer::uniform_stress_ratio(const Ends ends) const
  {
    return strains_laterally(ends) ? 0. : poisson_ratio / (1. - poisson_ratio);
  }

  double Layer::compliance_change(const double u) const
  {
    const double e = std::exp(-2. * u);
    if (base == Base::sliding)
      return e * (e - 1. - 2. * u) / (0.5 * (1. - e * e) + 2. * u * e);
    const double kappa = 3. - 4. * poisson_ratio;
    const double middle = 1. + kappa * kappa + 4. * u * u;
    return -e * (2. * kappa * e + 4. * u + middle) / (kappa * (1. + e * e) + middle * e);
  }

  Eigen::Index Layer::n_thin_modes(const double length) const
  {
    return static_cast<Eigen::Index>(std::ceil(40. * length / (layer_pi * thickness)));
  }

  void Layer::check(const std::string &name) const
  {
    std::ostringstream message;
    if (!(young_modulus > 0.))
      message << name << " has Young modulus " << young_modulus << ", which must be positive.";
    else if (!(poisson_ratio > -1. && poisson_ratio < 0.5))
      message << name << " has Poisson ratio " << poisson_ratio << ", which must lie between -1 and 0.5.";
    else if (!(thickness > 0.))
      message << name << " has thickness " << thickness << ", which must be positive.";
    if (!message.str().empty())
      throw UserError(message.str());
  }

  WaveStress AiryWave::stress(const double v, const double exp_rising, const double exp_falling) const
  {
    const double up = (rising + rising_slope * v) * exp_rising;
    const double down = (falling + falling_slope * v) * exp_falling;
    const double up_slope = rising_slope * exp_rising;
    const double down_slope = falling_slope * exp_falling;
    return {up + 2. * up_slope + down - 2. * down_slope, -(up + down), up + up_slope - down + down_slope};
  }

  WaveStress AiryWave::stress(const double v, const double u) const
  {
    return stress(v, std::exp(v - u), std::exp(-v - u));
  }

  AiryWave Layer::wave(const double u) const
  {
    Assert(u > 0., dealii::ExcMessage("a wave has a positive number"));
    const double e = std::exp(-2. * u);
    const double sinh_u = 0.5 * (1. - e); // times exp(u)
    const double cosh_u = 0.5 * (1. + e);
    if (base == Base::sliding)
    {
      const double determinant = 0.5 * (1. - e * e) + 2. * u * e;
      const double a = (sinh_u + u * cosh_u) / determinant;
      const double b = -sinh_u / determinant;
      return {a, b, a, -b};
    }
    const double m = 2. * (1. - poisson_ratio);
    const double determinant = 2. * ((m * m + u * u) * e + (2. * m - 1.) * sinh_u * sinh_u);
    const double a = (m * cosh_u + u * sinh_u) / determinant; // a/m above
    const double c = (u * cosh_u - (m - 1.) * sinh_u) / determinant;
    return {m * a + (m - 1.) * c, c - a, m * a - (m - 1.) * c, c + a};
  }

  AiryWave Layer::wave_change(const double u) const
  {
    AiryWave result = wave(u);
    result.rising -= 1. + u;
    result.rising_slope += 1.;
    return result;
  }

  Eigen::MatrixXd Layer::wave_displacement(const double length, const Eigen::VectorXd &x,
                                           const Eigen::MatrixXd &modes,
                                           const Eigen::MatrixXd &potential) const
  {
    Assert(length > 0. && modes.rows() > 0,
           dealii::ExcMessage("modes are those of a length, the mean first"));
    AssertDimension(modes.cols(), potential.cols());
    AssertDimension(potential.rows(), x.size());
    const Eigen::Index n_waves = modes.rows() - 1;
    Eigen::MatrixXd waves(x.size(), n_waves);
    for (Eigen::Index i = 0; i < n_waves; ++i)
    {
      const double lambda = double(i + 1) * layer_pi / length;
      waves.col(i) = compliance_change(lambda * thickness) / lambda * (lambda * x).array().cos();
    }
    return half_plane_compliance() * (waves * modes.bottomRows(n_waves) + potential);
  }
} // namespace abut
