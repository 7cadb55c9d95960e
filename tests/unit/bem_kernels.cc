// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over pairs of elements against quadrature that knows no closed form.
#include <abut/base/lagrange_basis.h>

#include <gtest/gtest.h>

#include "bem_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  constexpr unsigned int highest_degree = max_density_degree;
  using Precise = std::complex<long double>;

  /// Part of an element, between two places in its lengths.
  struct Part
  {
    const BoundaryElement *element;
    long double from, to; // of the distance from `origin`
    bool from_end;

    long double length() const { return (to - from) * static_cast<long double>(element->length); }
    Precise vertex() const { return Precise(from_end ? element->end : element->start); }
    Precise edge() const
    {
      return (from_end ? -1.l : 1.l) * (Precise(element->end) - Precise(element->start));
    }
    double eta(const long double place) const
    {
      return static_cast<double>(from_end ? 1.l - 2.l * place : 2.l * place - 1.l);
    }
  };

  /// ln|w|, conj(w)/w and 1/w against Legendre polynomials, x on one element, y on another.
  struct Reference
  {
    // In long double: they are sums over very many parts.
    using Sums = Eigen::Matrix<long double, highest_degree + 1, highest_degree + 1>;
    Sums log = Sums::Zero(), even_real = log, even_imag = log, inverse_real = log, inverse_imag = log;
  };

  /**
   * Gauss points on both parts where they are apart by the longer one's length, otherwise on the halves of
   * the longer one; parts below 1e-17 of the shorter element count for nothing, where elements touch.
   */
  class Bisection
  {
  public:
    Reference integrate(const BoundaryElement &a, const BoundaryElement &b)
    {
      smallest_ = 1e-17l * static_cast<long double>(std::min(a.length, b.length));
      for (const bool a_end : {false, true})
        for (const bool b_end : {false, true})
          add({&a, 0.l, .5l, a_end}, {&b, 0.l, .5l, b_end});
      return reference_;
    }

  private:
    static Precise between(const Part &a, const long double s, const Part &b, const long double t)
    {
      return (b.vertex() - a.vertex()) + t * b.edge() - s * a.edge();
    }
    void add(const Part &a, const Part &b)
    {
      const long double longer = std::max(a.length(), b.length());
      const long double apart = std::abs(between(a, .5l * (a.from + a.to), b, .5l * (b.from + b.to))) -
                                .5l * (a.length() + b.length());
      if (apart >= longer)
        add_points(a, b);
      else if (longer > smallest_)
      {
        const Part &halved = a.length() > b.length() ? a : b;
        const long double middle = .5l * (halved.from + halved.to);
        for (const Part &half : {Part{halved.element, halved.from, middle, halved.from_end},
                                 Part{halved.element, middle, halved.to, halved.from_end}})
          a.length() > b.length() ? add(half, b) : add(a, half);
      }
    }
    void add_points(const Part &a, const Part &b)
    {
      for (Eigen::Index p = 0; p < rule_.points.size(); ++p)
        for (Eigen::Index q = 0; q < rule_.points.size(); ++q)
        {
          const long double s = a.from + (a.to - a.from) * static_cast<long double>(rule_.points[p]),
                            t = b.from + (b.to - b.from) * static_cast<long double>(rule_.points[q]);
          const Complex w(between(a, s, b, t));
          const double weight =
              rule_.weights[p] * rule_.weights[q] * static_cast<double>(a.length() * b.length());
          const double log = weight * std::log(std::abs(w));
          const Complex even = weight * std::conj(w) / w, inverse = weight / w;
          const auto left = legendre_values(a.eta(s)), right = legendre_values(b.eta(t));
          for (unsigned int i = 0; i <= highest_degree; ++i)
            for (unsigned int j = 0; j <= highest_degree; ++j)
            {
              const double product = left[i] * right[j];
              reference_.log(i, j) += static_cast<long double>(product * log);
              reference_.even_real(i, j) += static_cast<long double>(product * even.real());
              reference_.even_imag(i, j) += static_cast<long double>(product * even.imag());
              reference_.inverse_real(i, j) += static_cast<long double>(product * inverse.real());
              reference_.inverse_imag(i, j) += static_cast<long double>(product * inverse.imag());
            }
        }
    }

    Reference reference_;
    GaussRule rule_{14};
    long double smallest_ = 0.l;
  };

  /// The largest errors of the kernels, relative to the largest integral of each, in either order of the
  /// pair.
  struct Errors
  {
    double log, even, double_layer;
    double largest() const { return std::max({log, even, double_layer}); }
  };

  /// Im(direction int int P_i P_j/w)/(2 pi)
  Eigen::MatrixXd reference_double_layer(const Reference &reference, const Complex direction)
  {
    return (direction.real() * reference.inverse_imag.cast<double>() +
            direction.imag() * reference.inverse_real.cast<double>()) /
           (2. * M_PI);
  }

  Errors errors(const BoundaryElement &a, const BoundaryElement &b, const Reference &reference,
                const GalerkinRule &rule)
  {
    const KernelMatrices matrices = kernel_matrices({a, b}, highest_degree, rule);
    const Eigen::Index n = highest_degree + 1;
    const auto upper = [&](const Eigen::MatrixXd &matrix) { return matrix.topRightCorner(n, n); };
    const auto lower = [&](const Eigen::MatrixXd &matrix) {
      return matrix.bottomLeftCorner(n, n).transpose();
    };
    const auto largest = [](const Eigen::MatrixXd &matrix) { return matrix.cwiseAbs().maxCoeff(); };
    const Eigen::MatrixXd log = reference.log.cast<double>(), even_real = reference.even_real.cast<double>(),
                          even_imag = reference.even_imag.cast<double>();
    for (const Eigen::MatrixXd *matrix : {&matrices.log, &matrices.even_real, &matrices.even_imag})
      EXPECT_EQ(largest(upper(*matrix) - lower(*matrix)), 0.);
    const double even_size = std::max(largest(even_real), largest(even_imag)),
                 inverse_size = std::max(largest(reference.inverse_real.cast<double>()),
                                         largest(reference.inverse_imag.cast<double>())) /
                                (2. * M_PI);
    return {largest(upper(matrices.log) - log) / largest(log),
            std::max(largest(upper(matrices.even_real) - even_real),
                     largest(upper(matrices.even_imag) - even_imag)) /
                even_size,
            std::max(largest(upper(matrices.double_layer) + reference_double_layer(reference, b.direction)),
                     largest(lower(matrices.double_layer) - reference_double_layer(reference, a.direction))) /
                inverse_size};
  }

  struct Pair
  {
    const char *name;
    BoundaryElement a, b;
  };

  /// From the end of an element at an angle to it, `length` times as long.
  Pair adjacent(const char *name, const double angle, const double length)
  {
    const Complex corner(1.25, .25), edge(.75, .5); // without round-off
    return {name, {corner - edge, corner}, {corner, corner + length * edge * std::polar(1., angle)}};
  }

  /// An element of length 1 and another that runs back beside it from a point at a distance from its end.
  Pair apart(const char *name, const Complex from, const Complex to)
  {
    const Complex start(.2, -.1), direction = std::polar(1., .7);
    return {name, {start, start + direction}, {start + from * direction, start + to * direction}};
  }

  std::vector<Pair> pairs()
  {
    return {adjacent("flat", 0., 1.),
            adjacent("flat, short", 0., 0x1p-13),
            adjacent("nearly flat", 1e-3, .7),
            adjacent("right angle", .5 * M_PI, 1.),
            adjacent("right angle, short", .5 * M_PI, 1e-4),
            adjacent("right angle, long", .5 * M_PI, 30.),
            adjacent("re-entrant", -.5 * M_PI, .6),
            adjacent("sharp", M_PI - .3, 1.1),
            apart("thin", Complex(1., 1e-2), Complex(0., 1e-2)),
            apart("thin and shifted", Complex(.7, 1e-3), Complex(.6, 1e-3)),
            apart("thin and tilted", Complex(1.2, 1e-2), Complex(-.3, .3)),
            apart("end above the middle", Complex(.4, 1e-4), Complex(.5, .7)),
            apart("end close to end", Complex(1. + 1e-6, 1e-6), Complex(1.4, .8)),
            apart("small and close", Complex(.4, 1e-3), Complex(.3999, 1e-3)),
            apart("behind", Complex(1.02, 0.), Complex(1.7, 0.)),
            apart("half a length", Complex(1., .5), Complex(0., .5)),
            apart("a length", Complex(1., 1.01), Complex(0., 1.01)),
            apart("two lengths", Complex(1., 2.05), Complex(0., 2.05)),
            apart("four lengths", Complex(5.1, 1.), Complex(6.1, 1.5)),
            apart("sixteen lengths", Complex(5., 16.), Complex(4., 16.3)),
            apart("short and sixteen", Complex(5., 16.), Complex(4.9, 16.)),
            apart("sixty-four lengths", Complex(60., 30.), Complex(61., 29.)),
            apart("1e7 lengths", Complex(1e7, 2e6), Complex(1e7, 2e6 + 3.))};
  }
} // namespace

TEST(BemKernels, AgreeWithBisectionForEveryPair)
{
  for (const Pair &pair : pairs())
  {
    const Reference reference = Bisection().integrate(pair.a, pair.b);
    const Errors found = errors(pair.a, pair.b, reference, GalerkinRule::precise());
    EXPECT_LT(found.log, 1e-13) << pair.name;
    EXPECT_LT(found.even, 1e-13) << pair.name;
    EXPECT_LT(found.double_layer, 1e-13) << pair.name;
    // For estimates the worst is an end just above the middle of an element.
    const double enough = pair.name == std::string("end above the middle") ? 2e-3 : 1e-4;
    EXPECT_LT(errors(pair.a, pair.b, reference, GalerkinRule::estimating()).largest(), enough) << pair.name;
  }
}

TEST(BemKernels, FormTheDoubleLayerOfOneLineAsZero)
{
  // Vertices with round-off, and lengths down to 1e-5: the heights over the line are nothing but noise.
  const Complex start(.3, .1), side = std::polar(.77, .6);
  std::vector<Complex> vertices;
  for (const double place : {0., 1e-5, 1e-4, .01, .3, .6, .99, 1.})
    vertices.push_back(start + place * side);
  Elements elements;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    elements.emplace_back(vertices[i], vertices[i + 1]);
  EXPECT_EQ(kernel_matrices(elements, 2, GalerkinRule::precise()).double_layer.norm(), 0.);
  // A kink of 1e-9 is none.
  elements.emplace_back(vertices.back(), vertices.back() + side * std::polar(.1, 1e-9));
  EXPECT_GT(kernel_matrices(elements, 2, GalerkinRule::precise()).double_layer.norm(), 1e-12);
}

TEST(BemKernels, ScaleWithTheCoordinates)
{
  const Elements elements = l_shape(graded_parts(6, 2.));
  const KernelMatrices plain = kernel_matrices(elements, 2, GalerkinRule::precise());
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(plain.log.rows());
  for (Eigen::Index m = 0; m < plain.lengths.size(); ++m)
    lengths[3 * m] = plain.lengths[m];
  for (const double factor : {1e-6, 1e6})
  {
    const KernelMatrices matrices = kernel_matrices(scaled(elements, factor), 2, GalerkinRule::precise());
    const double square = factor * factor, log = std::log(factor);
    const Eigen::MatrixXd shifted = plain.log + log * lengths * lengths.transpose();
    EXPECT_LT((matrices.log / square - shifted).norm(), 1e-13 * shifted.norm());
    EXPECT_LT((matrices.even_real / square - plain.even_real).norm(), 1e-13 * plain.even_real.norm());
    EXPECT_LT((matrices.even_imag / square - plain.even_imag).norm(), 1e-13 * plain.even_imag.norm());
    EXPECT_LT((matrices.double_layer / factor - plain.double_layer).norm(),
              1e-13 * plain.double_layer.norm());
  }
}
