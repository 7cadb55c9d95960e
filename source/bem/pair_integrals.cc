// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/pair_integrals.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    double distance_to_point(const BoundaryElement &element, const Complex z)
    {
      const Complex from_start = std::conj(element.direction) * (z - element.start);
      const double along = std::clamp(from_start.real(), 0., element.length);
      return std::abs(from_start - along);
    }

    /// int P_i(x) Q_j(x) dx over -1 < x < 1.
    double legendre_product(const unsigned int i, const unsigned int j)
    {
      if ((i + j) % 2 == 0)
        return 0.;
      return 2. / ((double(i) - double(j)) * (i + j + 1.));
    }

    /// int int P_i(s) P_j(t) ln |s - t| over -1 < s, t < 1: int P_j ln |s - .| = 2 (Q_{j+1} -
    /// Q_{j-1})/(2j+1).
    double self_logarithm(const unsigned int i, const unsigned int j)
    {
      if (i == 0 && j == 0)
        return 4. * std::log(2.) - 6.;
      if (j == 0)
        return self_logarithm(j, i);
      return 2. / (2. * j + 1.) * (legendre_product(i, j + 1) - legendre_product(i, j - 1));
    }
  } // namespace

  PairIntegrals::PairIntegrals(const unsigned int degree)
      : log(PairBlock::Zero(degree + 1, degree + 1)), even_real(log), even_imag(log), double_layer(log),
        reversed(log)
  {}

  double distance(const BoundaryElement &a, const BoundaryElement &b)
  {
    return std::min({distance_to_point(a, b.start), distance_to_point(a, b.end),
                     distance_to_point(b, a.start), distance_to_point(b, a.end)});
  }

  bool collinear(const BoundaryElement &a, const BoundaryElement &b, const double round_off)
  {
    Assert(round_off >= 0., dealii::ExcMessage("a rounding is a length"));
    const BoundaryElement &longer = a.length < b.length ? b : a, &shorter = a.length < b.length ? a : b;
    const double along_x = longer.direction.real(), along_y = longer.direction.imag();
    double reach = longer.length, off = 0.;
    for (const Complex &vertex : {shorter.start, shorter.end})
    {
      const double x = vertex.real() - longer.start.real(), y = vertex.imag() - longer.start.imag();
      reach = std::max(reach, std::abs(along_x * x + along_y * y));
      off = std::max(off, std::abs(along_x * y - along_y * x));
    }
    return off * longer.length <= round_off * reach;
  }

  PairIntegrals self_integrals(const BoundaryElement &element, const unsigned int degree)
  {
    PairIntegrals integrals(degree);
    const double half = .5 * element.length;
    for (unsigned int j = 0; j <= degree; ++j)
      for (unsigned int i = 0; i <= degree; ++i)
        integrals.log(i, j) = half * half * self_logarithm(i, j);
    integrals.log(0, 0) += 4. * half * half * std::log(half);
    const Complex even = std::conj(element.direction * element.direction);
    integrals.even_real(0, 0) = 4. * half * half * even.real();
    integrals.even_imag(0, 0) = 4. * half * half * even.imag();
    return integrals;
  }
} // namespace abut
