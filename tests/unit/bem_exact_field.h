// SPDX-License-Identifier: LGPL-2.1-or-later
// A field of plane strain known exactly, and polygons to put it into.
#pragma once

#include <abut/bem/interior_stress.h>

#include <vector>

/**
 * Goursat's functions phi = a z^(m+1) + b z, psi = c z^(m+1) + d z, m = degree. On straight elements
 * tractions and slopes are polynomials of degree m, which boundary elements represent exactly. With k = 3 - 4
 * nu 2 G u = k phi - z conj(phi') - conj(psi) + 2 G i rotation z s_xx + s_yy = 4 Re phi',   s_yy - s_xx + 2i
 * s_xy = 2 (conj(z) phi'' + psi')
 */
struct ExactField
{
  double shear_modulus, poisson_ratio, rotation = 0.;
  unsigned int degree = 1;

  abut::Stress stress(abut::Complex z) const;
  abut::Complex traction(abut::Complex z, abut::Complex direction) const;
  abut::Complex slope(abut::Complex z, abut::Complex direction) const;
  abut::BoundaryValues values(const std::vector<abut::BoundaryElement> &elements) const;
  /// The largest traction, or slope times 2 G, at the start of an element: what errors are relative to.
  double scale(const std::vector<abut::BoundaryElement> &elements) const;

private:
  abut::Complex phi_1(abut::Complex z) const; // derivatives
  abut::Complex phi_2(abut::Complex z) const;
  abut::Complex psi_1(abut::Complex z) const;
};

/// Where n elements of one size divide a side from 0 to 1; or n + n that shrink by `ratio` towards both ends.
std::vector<double> uniform_places(unsigned int n);
std::vector<double> graded_places(unsigned int n, double ratio);

/// Each side of a polygon divided alike.
std::vector<abut::BoundaryElement> divided_polygon(const std::vector<abut::Complex> &corners,
                                                   const std::vector<double> &places);

/// The Frobenius norm of the difference; infinite if that is not a number.
double stress_distance(const abut::Stress &a, const abut::Stress &b);
