// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_element.h>

#include <array>

namespace abut
{
  /// Densities on an element are polynomials up to this degree.
  constexpr unsigned int max_density_degree = 4;

  /// P_0 ... P_n at eta, n = max_density_degree.
  std::array<double, max_density_degree + 1> legendre_values(double eta);

  /**
   * What the kernels of plane elasticity make of Legendre polynomials on an element, seen from the place x in
   * its frame. With w = direction (length/2) (eta - x) and n = 0, 1, ...
   *
   *   log[n]    = int P_n(eta) ln |eta - x| d eta
   *   first[n]  = int P_n(eta) / (eta - x) d eta     = -2 Q_n(x)
   *   second[n] = int P_n(eta) / (eta - x)^2 d eta   = -2 Q_n'(x)
   *
   * over -1 < eta < 1, with the Legendre functions of the second kind Q_n.
   */
  struct LegendreMoments
  {
    std::array<double, max_density_degree + 1> log{};
    std::array<Complex, max_density_degree + 1> first{};
    std::array<Complex, max_density_degree + 1> second{};
  };

  /**
   * The moments up to `degree` in closed form: one logarithm and the three-term recurrence, accurate at any
   * distance from the element down to 1e-12 of its length. Far away it cancels: for |x| > 8 (four lengths)
   * take Gauss points, n of which have an error of about |2 x|^(-2 n). On the element itself `first` takes
   * the limit from one side; at its very ends only log[] is finite.
   */
  LegendreMoments legendre_moments(const LocalPlace &place, unsigned int degree);

  /// The same without log[], in half the time.
  LegendreMoments cauchy_moments(const LocalPlace &place, unsigned int degree);
} // namespace abut
