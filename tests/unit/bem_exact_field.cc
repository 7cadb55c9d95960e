// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bem_exact_field.h"

#include <abut/base/lagrange_basis.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace abut;

namespace
{
  const Complex goursat_a(.7, .4), goursat_b(.9, .25), goursat_c(-.3, .8), goursat_d(.5, -.6);

  /// With 0^0 = 1, unlike std::pow.
  Complex power(const Complex z, const unsigned int exponent)
  {
    return exponent == 0 ? Complex(1.) : z * power(z, exponent - 1);
  }
} // namespace

Complex ExactField::phi_1(const Complex z) const
{
  return (degree + 1.) * goursat_a * power(z, degree) + goursat_b;
}
Complex ExactField::phi_2(const Complex z) const
{
  return degree == 0 ? Complex(0.) : (degree + 1.) * degree * goursat_a * power(z, degree - 1);
}
Complex ExactField::psi_1(const Complex z) const
{
  return (degree + 1.) * goursat_c * power(z, degree) + goursat_d;
}

Stress ExactField::stress(const Complex z) const
{
  const double trace = 4. * phi_1(z).real();
  const Complex deviator = 2. * (std::conj(z) * phi_2(z) + psi_1(z));
  return {.5 * (trace - deviator.real()), .5 * (trace + deviator.real()), .5 * deviator.imag(),
          poisson_ratio * trace};
}

Complex ExactField::traction(const Complex z, const Complex direction) const
{
  const Stress s = stress(z);
  const Complex n(direction.imag(), -direction.real());
  return {s.xx * n.real() + s.xy * n.imag(), s.xy * n.real() + s.yy * n.imag()};
}

Complex ExactField::slope(const Complex z, const Complex direction) const
{
  const double kolosov = 3. - 4. * poisson_ratio;
  const Complex conjugate_part = z * std::conj(phi_2(z)) + std::conj(psi_1(z));
  const Complex along = kolosov * phi_1(z) - std::conj(phi_1(z));
  return (along * direction - conjugate_part * std::conj(direction)) / (2. * shear_modulus) +
         Complex(0., rotation) * direction;
}

BoundaryValues ExactField::values(const std::vector<BoundaryElement> &elements) const
{
  const GaussRule gauss(degree + 1);
  const auto n = static_cast<Eigen::Index>(elements.size());
  BoundaryValues values{Eigen::MatrixXcd::Zero(degree + 1, n), Eigen::MatrixXcd::Zero(degree + 1, n)};
  for (Eigen::Index e = 0; e < n; ++e)
    for (Eigen::Index j = 0; j < gauss.points.size(); ++j)
    {
      const BoundaryElement &element = elements[static_cast<std::size_t>(e)];
      const double eta = 2. * gauss.points[j] - 1.;
      const Complex z = element.point(eta);
      for (unsigned int m = 0; m <= degree; ++m)
      {
        const double weight = (2. * m + 1.) * gauss.weights[j] * std::legendre(m, eta);
        values.traction(m, e) += weight * traction(z, element.direction);
        values.slope(m, e) += weight * slope(z, element.direction);
      }
    }
  return values;
}

double ExactField::scale(const std::vector<BoundaryElement> &elements) const
{
  double largest = 0.;
  for (const BoundaryElement &element : elements)
    largest = std::max({largest, std::abs(traction(element.start, element.direction)),
                        2. * shear_modulus * std::abs(slope(element.start, element.direction))});
  return largest;
}

std::vector<double> uniform_places(const unsigned int n)
{
  std::vector<double> places;
  for (unsigned int i = 0; i <= n; ++i)
    places.push_back(double(i) / n);
  return places;
}

std::vector<double> graded_places(const unsigned int n, const double ratio)
{
  std::vector<double> places{0.};
  for (unsigned int i = 0; i < 2 * n; ++i)
    places.push_back(places.back() + std::pow(ratio, std::min(i, 2 * n - 1 - i)));
  const double total = places.back();
  for (double &place : places)
    place /= total;
  return places;
}

std::vector<BoundaryElement> divided_polygon(const std::vector<Complex> &corners,
                                             const std::vector<double> &places)
{
  std::vector<Complex> nodes;
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
      nodes.push_back(corners[c] + places[i] * (corners[(c + 1) % corners.size()] - corners[c]));
  std::vector<BoundaryElement> elements;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    elements.emplace_back(nodes[i], nodes[(i + 1) % nodes.size()]);
  return elements;
}

double stress_distance(const Stress &a, const Stress &b)
{
  const double distance = std::sqrt((a - b).square());
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}
