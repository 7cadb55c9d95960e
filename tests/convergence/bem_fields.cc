// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bem_study.h"
#include <cmath>

namespace abut
{
  std::vector<double> uniform(const unsigned int n)
  {
    return graded_to_start(n, 1.);
  }

  std::vector<double> graded_to_start(const unsigned int n, const double exponent)
  {
    std::vector<double> places;
    for (unsigned int i = 0; i < n; ++i)
      places.push_back(std::pow(static_cast<double>(i) / n, exponent));
    return places;
  }

  std::vector<double> graded_to_end(const unsigned int n, const double exponent)
  {
    std::vector<double> places;
    for (unsigned int i = 0; i < n; ++i)
      places.push_back(1. - std::pow(static_cast<double>(n - i) / n, exponent));
    return places;
  }

  Curve divided(const std::vector<DividedSide> &sides)
  {
    Curve curve;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      curve.sides.push_back(curve.vertices.size());
      for (const double place : sides[i].places)
        curve.vertices.push_back(sides[i].start +
                                 place * (sides[(i + 1) % sides.size()].start - sides[i].start));
    }
    return curve;
  }

  Curve regular_polygon(const unsigned int n, const double radius, const bool inside_out)
  {
    Curve curve{{}, {0}};
    for (unsigned int i = 0; i < n; ++i)
      curve.vertices.push_back(std::polar(radius, (inside_out ? -2. : 2.) * M_PI * i / n));
    return curve;
  }

  std::function<Complex(Complex, Complex)> traction_of(const std::function<Stress(Complex)> &stress)
  {
    return [stress](const Complex z, const Complex normal) {
      const Stress s = stress(z);
      return Complex(s.xx * normal.real() + s.xy * normal.imag(),
                     s.xy * normal.real() + s.yy * normal.imag());
    };
  }

  PlaneField from_potentials(const Material &material, const std::function<Potentials(Complex)> &potentials)
  {
    const double nu = material.poisson_ratio, k = 3. - 4. * nu;
    PlaneField field;
    field.displacement = [=](const Complex z) {
      const Potentials p = potentials(z);
      return (k * p.phi - z * std::conj(p.phi_1) - std::conj(p.psi)) / (2. * material.mu());
    };
    field.stress = [=](const Complex z) -> Stress {
      const Potentials p = potentials(z);
      const double sum = 4. * p.phi_1.real();
      const Complex difference = 2. * (std::conj(z) * p.phi_2 + p.psi_1);
      return {.5 * (sum - difference.real()), .5 * (sum + difference.real()), .5 * difference.imag(),
              nu * sum};
    };
    field.traction = traction_of(field.stress);
    return field;
  }

  PlaneField linear_field(const Material &material)
  {
    return from_potentials(material, [](const Complex z) -> Potentials {
      const Complex a(.4, .7), b(-.9, .5);
      return {a * z + Complex(.3, -.2), a, 0., b * z, b};
    });
  }

  PlaneField smooth_field(const Material &material)
  {
    return from_potentials(material, [](const Complex z) -> Potentials {
      const Complex a(.9, .4), b(-.3, 1.1), phi = Complex(.5, .2) * std::exp(a * z),
                                            psi = Complex(-.3, .6) * std::exp(b * z);
      return {phi, a * phi, a * a * phi, psi, b * psi};
    });
  }

  BoundaryCase in_units(const BoundaryCase &original, const double length, const double force_per_area)
  {
    BoundaryCase other = original;
    const PlaneField field = original.field;
    other.material.young_modulus *= force_per_area;
    for (Curve &curve : other.curves)
      for (Complex &vertex : curve.vertices)
        vertex *= length;
    for (Complex &point : other.points)
      point *= length;
    other.supported = [=](const Complex z, const Vector2 &normal) {
      return original.supported(z / length, normal);
    };
    other.field.displacement = [=](const Complex z) { return length * field.displacement(z / length); };
    other.field.stress = [=](const Complex z) { return field.stress(z / length) * force_per_area; };
    other.field.traction = [=](const Complex z, const Complex normal) {
      return field.traction(z / length, normal) * force_per_area;
    };
    return other;
  }
} // namespace abut
