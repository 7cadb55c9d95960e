// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/legendre_moments.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    /// z ln z, whose limit at 0 is 0.
    Complex z_log_z(const Complex z)
    {
      return z == 0. ? Complex(0.) : z * std::log(z);
    }

    /// ln((x + 1)/(x - 1)), branch cut on the element, to full relative accuracy at any distance: the square
    /// of the ratio is 1 + 4 Re x/|x - 1|^2, the angle that between -2 Im x and |x|^2 - 1.
    Complex log_of_ratio(const LocalPlace &place)
    {
      const double start = std::norm(place.from_start), end = std::norm(place.from_end);
      const double four_x = 2. * (place.from_start.real() + place.from_end.real());
      const double twice_height = 2. * (start < end ? place.from_start : place.from_end).imag();
      const double cosine =
          place.from_start.real() * place.from_end.real() + place.from_start.imag() * place.from_end.imag();
      return {.5 * (start < end ? -std::log1p(-four_x / start) : std::log1p(four_x / end)),
              std::atan2(-twice_height, cosine)};
    }

    /// Q_0 ... Q_{degree+1} and their derivatives: (2n+1) Q_n = Q_{n+1}' - Q_{n-1}'.
    struct SecondKind
    {
      SecondKind(const LocalPlace &place, const unsigned int degree)
      {
        const Complex x = place.x();
        const bool at_end = place.from_start == 0. || place.from_end == 0.;
        q[0] = at_end ? Complex(0.) : .5 * log_of_ratio(place);
        q[1] = at_end ? Complex(-1.) : x * q[0] - 1.;
        slope[0] = at_end ? Complex(0.) : -1. / (place.from_start * place.from_end);
        slope[1] = q[0] + x * slope[0];
        for (unsigned int n = 1; n <= degree; ++n)
        {
          q[n + 1] = ((2. * n + 1.) * x * q[n] - double(n) * q[n - 1]) / (n + 1.);
          slope[n + 1] = slope[n - 1] + (2. * n + 1.) * q[n];
        }
      }

      LegendreMoments cauchy_moments(const unsigned int degree) const
      {
        LegendreMoments moments;
        for (unsigned int n = 0; n <= degree; ++n)
        {
          moments.first[n] = -2. * q[n];
          moments.second[n] = -2. * slope[n];
        }
        return moments;
      }

      std::array<Complex, max_density_degree + 2> q{}, slope{};
    };
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
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    const SecondKind functions(place, degree);
    LegendreMoments moments = functions.cauchy_moments(degree);
    moments.log[0] = (z_log_z(place.from_start) - z_log_z(place.from_end)).real() - 2.;
    for (unsigned int n = 1; n <= degree; ++n)
      moments.log[n] = 2. * (functions.q[n + 1] - functions.q[n - 1]).real() / (2. * n + 1.);
    return moments;
  }

  LegendreMoments cauchy_moments(const LocalPlace &place, const unsigned int degree)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    return SecondKind(place, degree).cauchy_moments(degree);
  }
} // namespace abut
