// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/legendre_second_kind.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    constexpr std::size_t n_legendre_terms = 10;
    using LegendreSeries = std::array<double, n_legendre_terms>;

    // Q_n(tau) = tau^-(n+1) sum_i s_i tau^(-2i)
    constexpr LegendreSeries legendre_series(const int n)
    {
      LegendreSeries series{};
      series[0] = 1.;
      for (int k = 1; k <= n; ++k)
        series[0] *= k / (2. * k + 1.);
      for (int i = 0; i + 1 < int(n_legendre_terms); ++i)
        series[std::size_t(i + 1)] = series[std::size_t(i)] * (n + 2. * i + 1.) * (n + 2. * i + 2.) /
                                     ((2. * i + 2.) * (2. * n + 2. * i + 3.));
      return series;
    }

    constexpr LegendreSeries legendre_series_3 = legendre_series(3);
    constexpr LegendreSeries legendre_series_4 = legendre_series(4);

    // Terms n with |tau|^-(2n+3) < 1e-16: below the round-off of Q_0, of which Q_3 and Q_4 are small parts.
    std::size_t count_legendre_terms(const double square)
    {
      if (square < 100.)
        return square < 50. ? 10 : 8;
      if (square < 2e3)
        return square < 400. ? 7 : 5;
      return square < 1e5 ? 4 : 2;
    }

    LegendreSecondKind far_legendre(const std::complex<double> tau, const double square)
    {
      const std::complex<double> inverse = std::conj(tau) / square;
      const std::complex<double> step = inverse * inverse;
      std::complex<double> third = 0., fourth = 0.;
      for (std::size_t i = count_legendre_terms(square); i-- > 0;)
      {
        third = third * step + legendre_series_3[i];
        fourth = fourth * step + legendre_series_4[i];
      }
      LegendreSecondKind q;
      q[3] = third * step * step;
      q[4] = fourth * step * step * inverse;
      for (std::size_t n = 3; n >= 1; --n)
        q[n - 1] = (double(2 * n + 1) * tau * q[n] - double(n + 1) * q[n + 1]) / double(n);
      return q;
    }

    // (1/2) ln((z - b)/(z - c)), its angle between -pi/2 on the segment and 0 beyond.
    std::complex<double> half_logarithm(const std::complex<double> from_start,
                                        const std::complex<double> from_end)
    {
      const double start_square = std::norm(from_start);
      const double end_square = std::norm(from_end);
      const double smallest = std::numeric_limits<double>::min();
      const double logarithm =
          0.5 * (std::log(std::max(start_square, smallest)) - std::log(std::max(end_square, smallest)));
      if (start_square == 0. || end_square == 0.)
        return {0.5 * logarithm, -0.25 * boost::math::constants::pi<double>()};
      const double across = (from_start.real() - from_end.real()) * from_start.imag();
      const double along = from_start.real() * from_end.real() + from_start.imag() * from_end.imag();
      return {0.5 * logarithm, -0.5 * std::atan2(across, along)};
    }
  } // namespace

  LegendreSecondKind legendre_second_kind(const std::complex<double> from_start,
                                          const std::complex<double> from_end)
  {
    Assert(from_start.real() > from_end.real(), dealii::ExcMessage("a segment begins left of its end"));
    const std::complex<double> tau = (from_start + from_end) / (from_start.real() - from_end.real());
    const double square = std::norm(tau);
    if (square >= 25.)
      return far_legendre(tau, square);
    LegendreSecondKind q;
    q[0] = half_logarithm(from_start, from_end);
    q[1] = tau * q[0] - 1.;
    for (std::size_t n = 1; n < 4; ++n)
      q[n + 1] = (double(2 * n + 1) * tau * q[n] - double(n) * q[n - 1]) / double(n + 1);
    return q;
  }
} // namespace abut
