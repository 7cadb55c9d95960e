// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/layer.h>
#include <abut/user_error.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <sstream>

namespace abut
{
  double Layer::half_plane_compliance() const
  {
    return 2. * (1. - poisson_ratio * poisson_ratio) / young_modulus;
  }

  double Layer::uniform_compliance() const
  {
    return thickness * (1. + poisson_ratio) * (1. - 2. * poisson_ratio) /
           (young_modulus * (1. - poisson_ratio));
  }

  double Layer::compliance_change(const double u)
  {
    const double e = std::exp(-2. * u);
    return e * (e - 1. - 2. * u) / (0.5 * (1. - e * e) + 2. * u * e);
  }

  Eigen::Index Layer::n_thin_modes(const double length) const
  {
    return static_cast<Eigen::Index>(
        std::ceil(40. * length / (boost::math::constants::pi<double>() * thickness)));
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

  WaveStress half_plane_wave(const double scaled_depth)
  {
    const double decay = std::exp(-scaled_depth);
    return {(scaled_depth - 1.) * decay, -(1. + scaled_depth) * decay, scaled_depth * decay};
  }

  WaveStress layer_wave(const double u, const double v)
  {
    const double e = std::exp(-2. * u);
    const double sinh_u = 0.5 * (1. - e); // times exp(u)
    const double cosh_u = 0.5 * (1. + e);
    const double determinant = 0.25 * (1. - e * e) + u * e;
    const double a = (sinh_u + u * cosh_u) / determinant;
    const double b = -sinh_u / determinant;
    const double rising = std::exp(v - u);
    const double falling = std::exp(-v - u);
    const double cosh_v = 0.5 * (rising + falling); // times exp(-u)
    const double sinh_v = 0.5 * (rising - falling);
    return {a * cosh_v + b * (2. * cosh_v + v * sinh_v), -(a * cosh_v + b * v * sinh_v),
            a * sinh_v + b * (sinh_v + v * cosh_v)};
  }
} // namespace abut
