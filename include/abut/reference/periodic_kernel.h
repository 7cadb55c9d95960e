// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>

namespace abut
{
  /// cot z - 1/z and its derivative 1/z^2 - 1/sin^2 z.
  struct CotangentRest
  {
    std::complex<double> value;
    std::complex<double> slope;
  };

  /// From z and exponential = exp(2iz) in the upper half-plane; no pole nearer than |z| = pi.
  CotangentRest cotangent_without_pole(std::complex<double> z, std::complex<double> exponential);

  /// -ln(sin z/z), |z| < pi
  double minus_log_sinc(double z);
} // namespace abut
