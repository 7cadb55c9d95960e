// SPDX-License-Identifier: LGPL-2.1-or-later
// Lagrange polynomials and Gauss rules on [0, 1].
#include <abut/base/lagrange_basis.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace abut;

namespace
{
  constexpr unsigned int highest_degree = 5;
  const double places[] = {-.3, 0., .1, .37, .5, .82, 1., 1.2};
} // namespace

TEST(TraceBasis, NodesAreGaussLobattoPoints)
{
  // Abramowitz, Stegun, 25.4.32: zeros of P_p' and the ends, here on [0, 1].
  const std::vector<std::vector<double>> inner = {
      {},
      {0.},
      {-1. / std::sqrt(5.), 1. / std::sqrt(5.)},
      {-std::sqrt(3. / 7.), 0., std::sqrt(3. / 7.)},
      {-std::sqrt(1. / 3. + 2. * std::sqrt(7.) / 21.), -std::sqrt(1. / 3. - 2. * std::sqrt(7.) / 21.),
       std::sqrt(1. / 3. - 2. * std::sqrt(7.) / 21.), std::sqrt(1. / 3. + 2. * std::sqrt(7.) / 21.)}};
  for (unsigned int p = 1; p <= highest_degree; ++p)
  {
    const LagrangeBasis basis(p);
    ASSERT_EQ(basis.degree(), p);
    EXPECT_EQ(basis.nodes()[0], 0.);
    EXPECT_EQ(basis.nodes()[p], 1.);
    for (unsigned int i = 0; i + 1 < p; ++i)
      EXPECT_NEAR(basis.nodes()[i + 1], .5 * (1. + inner[p - 1][i]), 1e-15) << p;
  }
}

TEST(TraceBasis, IsOneAtItsNodeAndZeroAtTheOthers)
{
  for (unsigned int p = 1; p <= highest_degree; ++p)
  {
    const LagrangeBasis basis(p);
    for (Eigen::Index i = 0; i <= p; ++i)
      EXPECT_LT((basis.values(basis.nodes()[i]) - Eigen::VectorXd::Unit(p + 1, i)).norm(), 1e-13) << p;
  }
}

TEST(TraceBasis, ReproducesPolynomialsAndTheirDerivatives)
{
  for (unsigned int p = 1; p <= highest_degree; ++p)
  {
    const LagrangeBasis basis(p);
    for (unsigned int k = 0; k <= p; ++k)
    {
      const Eigen::VectorXd samples = basis.nodes().array().pow(static_cast<double>(k));
      for (const double s : places)
      {
        EXPECT_NEAR(basis.values(s).dot(samples), std::pow(s, k), 1e-13) << p << " " << k << " " << s;
        const double slope = k == 0 ? 0. : k * std::pow(s, k - 1.);
        EXPECT_NEAR(basis.derivatives(s).dot(samples), slope, 1e-12) << p << " " << k << " " << s;
      }
    }
  }
}

TEST(TraceBasis, RefusesDegreesItDoesNotKnow)
{
  EXPECT_THROW(LagrangeBasis(0), std::invalid_argument);
  EXPECT_THROW(LagrangeBasis(13), std::invalid_argument);
}

TEST(TraceBasis, GaussRulesAreExactToTheirDegree)
{
  for (unsigned int n = 1; n <= 9; ++n)
  {
    const GaussRule rule(n);
    const auto integral = [&](const double k) {
      return (rule.weights.array() * rule.points.array().pow(k)).sum();
    };
    for (unsigned int k = 0; k < 2 * n; ++k)
      EXPECT_NEAR(integral(k), 1. / (k + 1.), 2e-15) << n << " " << k;
    // The next one is missed by (n!)^4 / ((2n + 1) ((2n)!)^2), the square of the monic Legendre polynomial.
    double miss = 1. / (2. * n + 1.);
    for (unsigned int i = 1; i <= n; ++i)
      miss *= std::pow(i / static_cast<double>(n + i), 2.);
    EXPECT_NEAR(1. / (2. * n + 1.) - integral(2. * n), miss, 2e-15) << n;
  }
}

TEST(TraceBasis, RulesForSingularEndsIntegratePolynomials)
{
  const GaussRule rule = GaussRule::for_singular_ends(18);
  for (unsigned int k = 0; k <= 10; ++k)
    for (const Eigen::ArrayXd &s : {Eigen::ArrayXd(rule.points), Eigen::ArrayXd(1. - rule.points.array())})
      EXPECT_NEAR((rule.weights.array() * s.pow(static_cast<double>(k))).sum(), 1. / (k + 1.), 1e-13) << k;
}

TEST(TraceBasis, RulesForSingularEndsIntegrateInverseSquareRoots)
{
  // int_0^1 s^(k - 1/2) ds = 1/(k + 1/2), from either end, and both at once: int 1/sqrt(s (1 - s)) = pi.
  const GaussRule rule = GaussRule::for_singular_ends(18);
  const Eigen::ArrayXd from_start = rule.points, from_end = 1. - from_start;
  for (unsigned int k = 0; k <= 5; ++k)
    for (const Eigen::ArrayXd &s : {from_start, from_end})
      EXPECT_NEAR((rule.weights.array() * s.pow(k - .5)).sum(), 1. / (k + .5), 1e-13) << k;
  EXPECT_NEAR((rule.weights.array() / (from_start * from_end).sqrt()).sum(), M_PI, 1e-12);
}
