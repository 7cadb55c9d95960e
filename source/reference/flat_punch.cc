// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/flat_punch.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double punch_pi = boost::math::constants::pi<double>();

    void check_punch(const FlatPunchData &data)
    {
      std::ostringstream message;
      if (!(data.young_modulus > 0.))
        message << "The half-plane under the punch has Young modulus " << data.young_modulus
                << ", which must be positive.";
      else if (!(data.poisson_ratio > -1. && data.poisson_ratio < 0.5))
        message << "The half-plane under the punch has Poisson ratio " << data.poisson_ratio
                << ", which must lie between -1 and 0.5.";
      else if (!(data.half_width > 0. && data.force > 0.))
        message << "The punch has the half-width " << data.half_width << " and the force " << data.force
                << ", which must both be positive.";
      if (!message.str().empty())
        throw UserError(message.str());
    }

    std::complex<double> punch_position(const Vector2 &point)
    {
      return {point.x(), std::max(0., -point.y())};
    }

    // sqrt(z^2 - a^2), like z far away, cut along the punch; z in the closed upper half-plane.
    std::complex<double> punch_root(const std::complex<double> z, const double half_width)
    {
      return std::sqrt(z - half_width) * std::sqrt(z + half_width);
    }
  } // namespace

  FlatPunch::FlatPunch(const FlatPunchData &data) : data_(data)
  {
    check_punch(data_);
  }

  double FlatPunch::pressure(const double x) const
  {
    const double square = (data_.half_width - x) * (data_.half_width + x);
    return square < 0. ? 0. : data_.force / (punch_pi * std::sqrt(square));
  }

  ExactStress FlatPunch::stress(const Vector2 &point) const
  {
    Assert(point.allFinite(), dealii::ExcMessage("a point is finite"));
    const std::complex<double> z = punch_position(point);
    const double depth = z.imag();
    const std::complex<double> root = punch_root(z, data_.half_width);
    const std::complex<double> g = std::complex<double>(0., data_.force / punch_pi) / root;
    const std::complex<double> depth_slope = -depth * z / (root * root) * g;
    ExactStress result;
    result.xx = -(g.real() - depth_slope.imag());
    result.yy = -(g.real() + depth_slope.imag());
    result.xy = -depth_slope.real();
    result.zz = data_.poisson_ratio * (result.xx + result.yy);
    return result;
  }

  Vector2 FlatPunch::displacement(const Vector2 &point) const
  {
    const double nu = data_.poisson_ratio;
    const std::complex<double> z = punch_position(point);
    const double depth = z.imag();
    const std::complex<double> root = punch_root(z, data_.half_width);
    const std::complex<double> depth_g =
        depth > 0. ? std::complex<double>(0., depth * data_.force / punch_pi) / root : 0.;
    const std::complex<double> logarithm = std::log((z + root) / data_.half_width);
    const double real = -data_.force / punch_pi * (logarithm.imag() - 0.5 * punch_pi); // of F
    const double imaginary = data_.force / punch_pi * logarithm.real();
    return (1. + nu) / data_.young_modulus *
           Vector2(-(1. - 2. * nu) * real + depth_g.imag(), 2. * (1. - nu) * imaginary - depth_g.real());
  }
} // namespace abut
