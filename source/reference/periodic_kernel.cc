// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/periodic_kernel.h>

#include <cmath>

namespace abut
{
  CotangentRest cotangent_without_pole(const std::complex<double> z, const std::complex<double> exponential)
  {
    if (std::norm(z) < 0.05 * 0.05)
    {
      const std::complex<double> s = z * z;
      return {-z * (1. / 3. + s * (1. / 45. + s * (2. / 945. + s / 4725.))),
              -(1. / 3. + s * (1. / 15. + s * (2. / 189. + s / 675.)))};
    }
    const std::complex<double> reciprocal = std::conj(z) / std::norm(z);
    const std::complex<double> ratio = std::conj(1. - exponential) / std::norm(1. - exponential);
    return {std::complex<double>(0., -1.) * (1. + exponential) * ratio - reciprocal,
            reciprocal * reciprocal + 4. * exponential * ratio * ratio};
  }

  double minus_log_sinc(const double z)
  {
    return std::abs(z) < 1e-4 ? z * z / 6. : -std::log(std::sin(z) / z);
  }
} // namespace abut
