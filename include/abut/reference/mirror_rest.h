// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/periodic_pressure.h>

namespace abut
{
  /**
   * What is left of the potentials of a pressure p on [0, l], continued evenly with the period 2l, when its
   * poles (logarithms) at s and at the mirror images -s and 2l - s are taken away:
   *   G - (i/pi) int_0^l p (1/(z - s) + 1/(z + s) + 1/(z - 2l + s)) ds   and
   *   potential + (1/pi) int_0^l p (ln|x - s| + ln|x + s| + ln|2l - x - s|) ds.
   * For 0 <= Re z <= l this kernel has no pole nearer to [0, l] than l, so that 20 Gauss points of [0, l],
   * weighted with the exact integrals of p against their Lagrange polynomials, integrate it to 1e-15.
   */
  class MirrorRest
  {
  public:
    static constexpr Eigen::Index n_moments = 20;

    /// The moments int_0^l p(s) P_n(2s/l - 1) ds of p with the Legendre polynomials P_n, n < n_moments.
    MirrorRest(double length, const Eigen::VectorXd &moments);

    double potential(double x) const;
    PeriodicPressure::Potential complex_potential(std::complex<double> z) const;

  private:
    double length_;
    Eigen::VectorXd nodes_;
    Eigen::VectorXd weighted_;          // int p times the Lagrange polynomial of the node
    Eigen::VectorXcd node_exponential_; // exp(-i pi s/l) at the node s
  };

  /// P_0(t) ... P_{n-1}(t)
  Eigen::VectorXd legendre_polynomials(Eigen::Index n, double t);
} // namespace abut
