// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bem_testing.h"

#include <abut/base/lagrange_basis.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    using Entries = std::vector<Eigen::Triplet<double>>;

    const Complex field_a(.7, .4), field_b(.9, .25), field_c(-.3, .8), field_d(.5, -.6);

    LegendreBasis assembled(const Eigen::Index rows, const Eigen::Index columns, const Entries &entries)
    {
      LegendreBasis basis(rows, columns);
      basis.setFromTriplets(entries.begin(), entries.end());
      return basis;
    }

    std::vector<double> normalised(const std::vector<double> &parts)
    {
      double sum = 0.;
      for (const double part : parts)
        sum += part;
      std::vector<double> result;
      for (const double part : parts)
        result.push_back(part / sum);
      return result;
    }
  } // namespace

  std::vector<double> equal_parts(const unsigned int n)
  {
    return normalised(std::vector<double>(n, 1.));
  }

  std::vector<double> graded_parts(const unsigned int n, const double ratio)
  {
    std::vector<double> parts;
    for (unsigned int i = 0; i < n; ++i)
      parts.push_back(std::pow(ratio, -std::abs(i - .5 * (n - 1.))));
    return normalised(parts);
  }

  Elements polygon(const std::vector<Complex> &corners, const std::vector<double> &parts)
  {
    std::vector<Complex> vertices;
    for (std::size_t side = 0; side < corners.size(); ++side)
    {
      double place = 0.;
      for (const double part : parts)
      {
        vertices.push_back(corners[side] + place * (corners[(side + 1) % corners.size()] - corners[side]));
        place += part;
      }
    }
    Elements elements;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      elements.emplace_back(vertices[i], vertices[(i + 1) % vertices.size()]);
    return elements;
  }

  Elements rectangle(const std::vector<double> &parts, const double height)
  {
    const Complex origin(.05, .02), up(0., height);
    return polygon({origin, origin + .9, origin + .9 + up, origin + up}, parts);
  }

  Elements l_shape(const std::vector<double> &parts)
  {
    return polygon({Complex(0., 0.), Complex(1., 0.), Complex(1., .4), Complex(.5, .4), Complex(.5, .9),
                    Complex(0., .9)},
                   parts);
  }

  Elements rectangle_with_hole(const unsigned int n)
  {
    Elements elements = rectangle(equal_parts(n));
    const Elements hole =
        polygon({Complex(.3, .2), Complex(.35, .4), Complex(.6, .45), Complex(.55, .15)}, equal_parts(n));
    elements.insert(elements.end(), hole.begin(), hole.end());
    return elements;
  }

  Elements circle(const unsigned int n, const double radius)
  {
    std::vector<Complex> corners;
    for (unsigned int i = 0; i < n; ++i)
      corners.push_back(std::polar(radius, 2. * M_PI * i / n));
    return polygon(corners, {1.});
  }

  Elements scaled(const Elements &elements, const double factor)
  {
    Elements result;
    for (const BoundaryElement &element : elements)
      result.emplace_back(factor * element.start, factor * element.end);
    return result;
  }

  CubicField::CubicField(const double poisson_ratio) : factor_(3. - 4. * poisson_ratio) {}

  Complex CubicField::displacement(const Complex z) const
  {
    const Complex phi = field_a * z * z + field_b * z, psi = field_c * z * z + field_d * z;
    const Complex elastic = factor_ * phi - z * std::conj(2. * field_a * z + field_b) - std::conj(psi);
    return .5 * elastic + Complex(.3, -.2) + Complex(0., .1) * z;
  }

  Complex CubicField::slope(const Complex z, const BoundaryElement &element) const
  {
    // Of a quadratic function the difference is the derivative.
    return displacement(z + .5 * element.direction) - displacement(z - .5 * element.direction);
  }

  Complex CubicField::traction(const Complex z, const BoundaryElement &element) const
  {
    const double sum = 4. * (2. * field_a * z + field_b).real();
    const Complex difference = 2. * (std::conj(z) * 2. * field_a + 2. * field_c * z + field_d);
    const double s_xx = .5 * (sum - difference.real()), s_yy = .5 * (sum + difference.real()),
                 s_xy = .5 * difference.imag();
    const Complex normal = Complex(0., -1.) * element.direction;
    return {s_xx * normal.real() + s_xy * normal.imag(), s_xy * normal.real() + s_yy * normal.imag()};
  }

  LegendreBasis projected(const Elements &elements, const unsigned int degree, const Field &field)
  {
    const LegendreRule rule(degree + 3, degree);
    const auto n = static_cast<Eigen::Index>(elements.size() * (degree + 1));
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(2 * n);
    for (std::size_t m = 0; m < elements.size(); ++m)
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const Complex value = field(elements[m].point(rule.points[q]), elements[m]);
        for (unsigned int i = 0; i <= degree; ++i)
        {
          const auto row = static_cast<Eigen::Index>(m * (degree + 1) + i);
          coefficients[row] += (i + .5) * rule.weighted(q, i) * value.real();
          coefficients[n + row] += (i + .5) * rule.weighted(q, i) * value.imag();
        }
      }
    return as_basis(coefficients);
  }

  DisplacementBasis projected(const Elements &elements, const unsigned int degree, const CubicField &field)
  {
    return {projected(elements, degree,
                      [&](const Complex z, const BoundaryElement &) { return field.displacement(z); }),
            projected(elements, degree, [&](const Complex z, const BoundaryElement &element) {
              return field.slope(z, element);
            })};
  }

  std::vector<DisplacementBasis> rigid_motions(const Elements &elements, const unsigned int degree)
  {
    std::vector<DisplacementBasis> motions;
    for (const Complex shift : {Complex(1., 0.), Complex(0., 1.), Complex(0., 0.)})
    {
      const Complex turn = shift == 0. ? Complex(0., 1.) : Complex(0.);
      motions.push_back(
          {projected(elements, degree,
                     [&](const Complex z, const BoundaryElement &) { return shift + turn * z; }),
           projected(elements, degree, [&](const Complex, const BoundaryElement &element) {
             return turn * element.direction;
           })});
    }
    return motions;
  }

  LegendreBasis all_polynomials(const Elements &elements, const unsigned int degree)
  {
    const auto n = static_cast<Eigen::Index>(2 * elements.size() * (degree + 1));
    LegendreBasis basis(n, n);
    basis.setIdentity();
    return basis;
  }

  DisplacementBasis continuous_fields(const Elements &elements, const unsigned int degree)
  {
    const auto size = static_cast<int>(degree + 1), n = static_cast<int>(elements.size());
    Entries values, slopes;
    for (int component = 0; component < 2; ++component)
      for (int m = 0; m < n; ++m)
      {
        const BoundaryElement &element = elements[static_cast<std::size_t>(m)];
        const auto next = std::find_if(elements.begin(), elements.end(), [&](const BoundaryElement &other) {
          return other.start == element.end;
        });
        const int row = (component * n + m) * size, column = component * n * static_cast<int>(degree),
                  start = column + m, end = column + static_cast<int>(next - elements.begin());
        for (const auto &[vertex, sign] : {std::pair(start, -1.), std::pair(end, 1.)})
        {
          values.emplace_back(row, vertex, .5);
          values.emplace_back(row + 1, vertex, .5 * sign);
          slopes.emplace_back(row, vertex, sign / element.length);
        }
        // The integral of P_{q-1} is (P_q - P_{q-2})/(2q - 1).
        for (int q = 2; q < size; ++q)
        {
          values.emplace_back(row + q, column + n * (q - 1) + m, 1. / (2. * q - 1.));
          values.emplace_back(row + q - 2, column + n * (q - 1) + m, -1. / (2. * q - 1.));
          slopes.emplace_back(row + q - 1, column + n * (q - 1) + m, 2. / element.length);
        }
      }
    const int rows = 2 * n * size, columns = 2 * n * static_cast<int>(degree);
    return {assembled(rows, columns, values), assembled(rows, columns, slopes)};
  }
} // namespace abut
