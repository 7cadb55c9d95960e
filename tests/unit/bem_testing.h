// SPDX-License-Identifier: LGPL-2.1-or-later
// Polygons, bases on them, and a field of plane strain known exactly.
#pragma once

#include <abut/bem/layer_operators.h>

#include <functional>
#include <vector>

namespace abut
{
  using Elements = std::vector<BoundaryElement>;

  /// n equal parts of the unit interval; or parts whose lengths fall by `ratio` from the middle to the ends.
  std::vector<double> equal_parts(unsigned int n);
  std::vector<double> graded_parts(unsigned int n, double ratio);

  /// A closed polygon, each of its sides divided alike.
  Elements polygon(const std::vector<Complex> &corners, const std::vector<double> &parts);
  Elements rectangle(const std::vector<double> &parts, double height = .6);
  Elements l_shape(const std::vector<double> &parts);
  Elements rectangle_with_hole(unsigned int n);
  Elements circle(unsigned int n, double radius);
  Elements scaled(const Elements &elements, double factor);

  /**
   * The Airy function of degree 3 with Goursat's phi = a z^2 + b z, psi = c z^2 + d z, and a rigid motion,
   * for G = 1: 2 u = k phi - z conj(phi') - conj(psi), k = 3 - 4 nu; s_xx + s_yy = 4 Re phi',
   * s_yy - s_xx + 2i s_xy = 2 (conj(z) phi'' + psi'). u is quadratic, the stress linear.
   */
  class CubicField
  {
  public:
    explicit CubicField(double poisson_ratio);

    Complex displacement(Complex z) const;
    /// Derivative in the direction of an element.
    Complex slope(Complex z, const BoundaryElement &element) const;
    Complex traction(Complex z, const BoundaryElement &element) const;

  private:
    double factor_; // k
  };

  /// Legendre coefficients of a field that is a polynomial on every element, as a single column.
  using Field = std::function<Complex(Complex, const BoundaryElement &)>;
  LegendreBasis projected(const Elements &elements, unsigned int degree, const Field &field);
  DisplacementBasis projected(const Elements &elements, unsigned int degree, const CubicField &field);
  /// Two translations and a rotation.
  std::vector<DisplacementBasis> rigid_motions(const Elements &elements, unsigned int degree);

  /// Every Legendre polynomial an unknown of its own.
  LegendreBasis all_polynomials(const Elements &elements, unsigned int degree);
  /// Hat functions and the integrals of Legendre polynomials: the continuous fields of a degree.
  DisplacementBasis continuous_fields(const Elements &elements, unsigned int degree);
} // namespace abut
