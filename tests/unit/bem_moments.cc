// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed integrals of Legendre polynomials against the kernels on one element.
#include <abut/base/lagrange_basis.h>
#include <abut/bem/pair_integrals.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace abut;

namespace
{
  constexpr unsigned int highest_moment = max_density_degree;

  /// int f(t) dt over 0 < t < length, f analytic but for what lies within `scale` of t = 0: panels that
  /// double.
  Complex graded_integral(const double length, const double scale, const std::function<Complex(double)> &f)
  {
    const GaussRule rule(24);
    Complex sum = 0.;
    for (double from = 0., to = std::min(scale, length); from < length;
         from = to, to = std::min(2. * to, length))
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        sum += (to - from) * rule.weights[q] * f(from + (to - from) * rule.points[q]);
    return sum;
  }

  /// int P_n(eta) kernel(eta - x) d eta over -1 < eta < 1 at x = foot + offset.
  Complex moment(const unsigned int n, const double foot, const Complex offset,
                 const std::function<Complex(Complex)> &kernel)
  {
    Complex sum = 0.;
    for (const double side : {-1., 1.})
      sum += graded_integral(1. - side * foot, std::abs(offset), [&](const double t) {
        return std::legendre(n, foot + side * t) * kernel(side * t - offset);
      });
    return sum;
  }

  void expect_moments(const double foot, const Complex offset)
  {
    const double distance = std::abs(offset);
    const LegendreMoments moments =
        legendre_moments({foot + 1. + offset, foot - 1. + offset}, highest_moment);
    for (unsigned int n = 0; n <= highest_moment; ++n)
    {
      const Complex log =
          moment(n, foot, offset, [](const Complex w) { return .5 * std::log(std::norm(w)); });
      const Complex first = moment(n, foot, offset, [](const Complex w) { return 1. / w; });
      const Complex second = moment(n, foot, offset, [](const Complex w) { return 1. / (w * w); });
      EXPECT_NEAR(moments.log[n], log.real(), 1e-13) << foot << " " << offset << " " << n;
      EXPECT_LT(std::abs(moments.first[n] - first), 1e-13) << foot << " " << offset << " " << n;
      EXPECT_LT(std::abs(moments.second[n] - second) * distance, 1e-13) << foot << " " << offset << " " << n;
    }
  }

  /// int int s^i t^j ln|s - t| over 0 < s, t < 1: by parts in t, then int s^m ln(1 - s) = -H_{m+1}/(m+1).
  double double_logarithm(const unsigned int i, const unsigned int j)
  {
    const auto harmonic = [](const unsigned int n) {
      double sum = 0.;
      for (unsigned int k = 1; k <= n; ++k)
        sum += 1. / k;
      return sum / n;
    };
    double sum = -harmonic(i + 1) + harmonic(i + j + 2) - 1. / std::pow(i + j + 2., 2.);
    for (unsigned int k = 0; k <= j; ++k)
      sum -= 1. / ((j - k + 1.) * (i + k + 1.));
    return sum / (j + 1.);
  }

  /// Legendre coefficients of ((1 + eta)/2)^i.
  Eigen::VectorXd power_coefficients(const unsigned int i)
  {
    const GaussRule rule(highest_moment + 1);
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(highest_moment + 1);
    for (unsigned int n = 0; n <= highest_moment; ++n)
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
        coefficients[n] += (2. * n + 1.) * rule.weights[q] * std::pow(rule.points[q], i) *
                           std::legendre(n, 2. * rule.points[q] - 1.);
    return coefficients;
  }
} // namespace

TEST(BemMoments, AgreeWithQuadratureAboveTheElement)
{
  for (const double distance : {1., 1e-1, 1e-3, 1e-6, 1e-9, 1e-12})
    for (const double foot : {-1., -.26, .9, 1.})
      for (const double side : {-1., 1.})
        expect_moments(foot, Complex(0., 2. * side * distance));
}

TEST(BemMoments, AgreeWithQuadratureAroundTheEnds)
{
  for (const double distance : {.5, 1e-1, 1e-3, 1e-6, 1e-9, 1e-12})
    for (const double angle : {0., .1, .8, 2., 2.6})
      for (const double end : {-1., 1.})
        expect_moments(end, end * std::polar(2. * distance, angle));
}

TEST(BemMoments, TakeTheLimitFromTheBodyOnTheElement)
{
  // first: the principal value, int (P(eta) - P(x))/(eta - x) + P(x) ln((1 - x)/(1 + x)), and i pi P(x).
  const GaussRule rule(highest_moment + 1);
  for (const double x : {-.999, -.3, 0., .7})
  {
    const LegendreMoments moments = legendre_moments({x + 1., x - 1.}, highest_moment);
    for (unsigned int n = 0; n <= highest_moment; ++n)
    {
      double principal = std::legendre(n, x) * std::log((1. - x) / (1. + x));
      for (Eigen::Index q = 0; q < rule.points.size(); ++q)
      {
        const double eta = 2. * rule.points[q] - 1.;
        principal += 2. * rule.weights[q] * (std::legendre(n, eta) - std::legendre(n, x)) / (eta - x);
      }
      const Complex log = moment(n, x, 1e-18, [](const Complex w) { return .5 * std::log(std::norm(w)); });
      EXPECT_NEAR(moments.first[n].real(), principal, 1e-13) << x << " " << n;
      EXPECT_NEAR(moments.first[n].imag(), M_PI * std::legendre(n, x), 1e-14) << x << " " << n;
      EXPECT_NEAR(moments.log[n], log.real(), 1e-13) << x << " " << n;
    }
  }
}

TEST(BemMoments, IntegrateAnElementWithItselfExactly)
{
  const BoundaryElement element(Complex(.3, .1), Complex(.6, -.2));
  const double length = element.length;
  const PairIntegrals integrals = self_integrals(element, highest_moment);
  for (unsigned int i = 0; i <= highest_moment; ++i)
    for (unsigned int j = 0; j <= highest_moment; ++j)
    {
      const double exact =
          length * length * (double_logarithm(i, j) + std::log(length) / ((i + 1.) * (j + 1.)));
      EXPECT_NEAR(power_coefficients(i).dot(integrals.log * power_coefficients(j)), exact, 1e-15)
          << i << " " << j;
    }
  EXPECT_EQ(integrals.double_layer.norm(), 0.);
  EXPECT_EQ(integrals.reversed.norm(), 0.);
}
