// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <complex>

namespace abut
{
  /// Q_0 ... Q_4
  using LegendreSecondKind = std::array<std::complex<double>, 5>;

  /**
   * Legendre functions of the second kind Q_0 ... Q_4 at tau = (2z - b - c)/(c - b) for z in the closed upper
   * half-plane, given z - b and z - c of the segment b < c:
   *   Q_n(tau) = (1/2) int_{-1}^{1} P_n(t)/(tau - t) dt,
   * which turns the integral of a polynomial against 1/(z - s) over the segment into a short sum. On the
   * segment the limit from above, at its ends with a large finite number instead of the logarithm. By
   * (n+1) Q_{n+1} = (2n+1) tau Q_n - n Q_{n-1}: upwards from Q_0 where |tau| < 5, downwards from the series
   * in 1/tau of Q_4 and Q_3 beyond (Abramowitz & Stegun, ch. 8). Relative error of the largest about 1e-15.
   */
  LegendreSecondKind legendre_second_kind(std::complex<double> from_start, std::complex<double> from_end);
} // namespace abut
