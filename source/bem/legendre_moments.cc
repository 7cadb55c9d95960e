// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/legendre_moments.h>

namespace abut
{
  namespace
  {
    /// z ln z, whose limit at 0 is 0.
    Complex z_log_z(const Complex z)
    {
      return z == 0. ? Complex(0.) : z * std::log(z);
    }
  } // namespace

  std::array<double, max_density_degree + 1> legendre_values(const double eta)
  {
    std::array<double, max_density_degree + 1> p{{1., eta}};
    for (unsigned int n = 1; n < max_density_degree; ++n)
      p[n + 1] = ((2. * n + 1.) * eta * p[n] - n * p[n - 1]) / (n + 1.);
    return p;
  }

  LegendreMoments legendre_moments(const LocalPlace &place, const unsigned int degree)
  {
    // Q_0 ... Q_{degree+1} and their derivatives: (2n+1) Q_n = Q_{n+1}' - Q_{n-1}'.
    std::array<Complex, max_density_degree + 2> q{}, slope{};
    const Complex x = place.x();
    const bool at_end = place.from_start == 0. || place.from_end == 0.;
    q[0] = at_end ? Complex(0.) : .5 * std::log(place.from_start / place.from_end);
    q[1] = at_end ? Complex(-1.) : x * q[0] - 1.;
    slope[0] = at_end ? Complex(0.) : -1. / (place.from_start * place.from_end);
    slope[1] = q[0] + x * slope[0];
    for (unsigned int n = 1; n <= degree; ++n)
    {
      q[n + 1] = ((2. * n + 1.) * x * q[n] - double(n) * q[n - 1]) / (n + 1.);
      slope[n + 1] = slope[n - 1] + (2. * n + 1.) * q[n];
    }
    LegendreMoments moments;
    moments.log[0] = (z_log_z(place.from_start) - z_log_z(place.from_end)).real() - 2.;
    for (unsigned int n = 0; n <= degree; ++n)
    {
      if (n > 0)
        moments.log[n] = 2. * (q[n + 1] - q[n - 1]).real() / (2. * n + 1.);
      moments.first[n] = -2. * q[n];
      moments.second[n] = -2. * slope[n];
    }
    return moments;
  }
} // namespace abut
