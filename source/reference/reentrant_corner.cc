// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/reentrant_corner.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <complex>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double corner_angle = 1.5 * boost::math::constants::pi<double>();

    // The bracket holds the one root in (0, 1); alpha = 1 is a rotation.
    double find_corner_exponent()
    {
      const auto equation = [](double alpha) {
        return std::sin(alpha * corner_angle) + alpha * std::sin(corner_angle);
      };
      std::uintmax_t n_iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          equation, 0.3, 0.8, boost::math::tools::eps_tolerance<double>(52), n_iterations);
      return 0.5 * (bracket.first + bracket.second);
    }

    std::complex<double> corner_direction()
    {
      return std::polar(1., 0.5 * corner_angle);
    }

    // The point in coordinates along and across the bisector.
    std::complex<double> corner_position(const Vector2 &point)
    {
      return std::complex<double>(point.x(), point.y()) * std::conj(corner_direction());
    }
  } // namespace

  ReentrantCorner::ReentrantCorner(const double young_modulus, const double poisson_ratio,
                                   const double amplitude)
      : young_modulus_(young_modulus), poisson_ratio_(poisson_ratio), exponent_(find_corner_exponent())
  {
    std::ostringstream message;
    if (!(young_modulus > 0.))
      message << "The corner has Young modulus " << young_modulus << ", which must be positive.";
    else if (!(poisson_ratio > -1. && poisson_ratio < 0.5))
      message << "The corner has Poisson ratio " << poisson_ratio << ", which must lie between -1 and 0.5.";
    else if (!std::isfinite(amplitude))
      message << "The corner has the amplitude " << amplitude << ", which must be finite.";
    if (!message.str().empty())
      throw UserError(message.str());
    const double ratio = -std::cos(exponent_ * corner_angle);
    first_ = amplitude / (exponent_ * (1. + exponent_ + ratio));
    second_ = ratio * first_;
  }

  ExactStress ReentrantCorner::stress(const Vector2 &point) const
  {
    Assert(!point.isZero(0.), dealii::ExcMessage("the stress at the corner is infinite"));
    const std::complex<double> z = corner_position(point);
    const std::complex<double> slope = exponent_ * std::pow(z, exponent_ - 1.);
    const double mean = 2. * first_ * slope.real();
    const std::complex<double> turned = (first_ * (exponent_ - 1.) * std::conj(z) / z + second_) * slope;
    const std::complex<double> difference = turned * std::conj(corner_direction() * corner_direction());
    ExactStress result;
    result.xx = mean - difference.real();
    result.yy = mean + difference.real();
    result.xy = difference.imag();
    result.zz = 2. * poisson_ratio_ * mean;
    return result;
  }

  Vector2 ReentrantCorner::displacement(const Vector2 &point) const
  {
    if (point.isZero(0.))
      return Vector2::Zero();
    const std::complex<double> z = corner_position(point);
    const std::complex<double> power = std::pow(z, exponent_);
    const double kappa = 3. - 4. * poisson_ratio_;
    const std::complex<double> turned =
        kappa * first_ * power - std::conj((first_ * exponent_ * std::conj(z) / z + second_) * power);
    const std::complex<double> result = (1. + poisson_ratio_) / young_modulus_ * turned * corner_direction();
    return {result.real(), result.imag()};
  }
} // namespace abut
