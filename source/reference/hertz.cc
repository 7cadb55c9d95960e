// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/hertz.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  HertzLineContact::HertzLineContact(const double force, const double radius, const double modulus)
  {
    if (!(force > 0. && radius > 0. && modulus > 0.))
    {
      std::ostringstream message;
      message << "The Hertz contact has the force " << force << ", the composite radius " << radius
              << " and the composite modulus " << modulus << ", which must all be positive.";
      throw UserError(message.str());
    }
    const double pi = boost::math::constants::pi<double>();
    half_width_ = std::sqrt(4. * force * radius / (pi * modulus));
    max_pressure_ = 2. * force / (pi * half_width_);
  }

  double HertzLineContact::pressure(const double x) const
  {
    const double t = x / half_width_;
    return max_pressure_ * std::sqrt(std::max(0., (1. - t) * (1. + t)));
  }

  double composite_modulus(const double young_modulus_1, const double poisson_ratio_1,
                           const double young_modulus_2, const double poisson_ratio_2)
  {
    Assert(young_modulus_1 > 0. && young_modulus_2 > 0., dealii::ExcMessage("moduli are positive"));
    return 1. / ((1. - poisson_ratio_1 * poisson_ratio_1) / young_modulus_1 +
                 (1. - poisson_ratio_2 * poisson_ratio_2) / young_modulus_2);
  }
} // namespace abut
