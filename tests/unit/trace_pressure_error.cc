// SPDX-License-Identifier: LGPL-2.1-or-later
// The estimated error of reported pressures.
#include <abut/trace/pressure_error.h>

#include <gtest/gtest.h>

#include "surface_testing.h"
#include <cmath>

using namespace abut;

namespace
{
  using Index = Eigen::Index;

  /// A line with n boxes and two half ones, x from 0 to 1.
  TestSurface line(const unsigned int n)
  {
    return TestSurface(make_line(1., 0., 0., n), make_line(0., 1., 0., n), .1);
  }

  /// At the places of the parts.
  template <typename Function> Eigen::VectorXd values(const TestSurface &surface, const Function &pressure)
  {
    Eigen::VectorXd result(static_cast<Index>(surface.parts().size()));
    for (Index k = 0; k < result.size(); ++k)
      result[k] = pressure(surface.parts()[static_cast<std::size_t>(k)].place_arc);
    return result;
  }

  double end_error(const PressureError &error)
  {
    double sum = 0.;
    for (const PressureError::End &end : error.ends)
      sum += end.square;
    return std::sqrt(sum);
  }
} // namespace

TEST(PressureErrors, AreAtTheEndsOfAHertzianContactAlone)
{
  double before = 0.;
  for (const unsigned int n : {20u, 40u, 80u})
  {
    const TestSurface surface = line(n);
    const Eigen::VectorXd p =
        values(surface, [](const double x) { return std::sqrt(std::max(0., .09 - std::pow(x - .52, 2))); });
    const PressureError error = pressure_error(surface.partition, p, p);
    EXPECT_LT(error.of_parts.cwiseSqrt().maxCoeff(), 1e-12); // p^2 is a parabola
    ASSERT_EQ(error.ends.size(), 2u);
    EXPECT_NEAR(error.ends[0].arc, .22, 1. / n);
    EXPECT_NEAR(error.ends[1].arc, .82, 1. / n);
    EXPECT_NEAR(error.ends[0].square / error.ends[1].square, 1., .5); // the ends lie elsewhere in their parts
    const double now = end_error(error);
    if (before > 0.)
    {
      EXPECT_NEAR(before / now, 2., .3); // half as large with parts of half the length, but for the logarithm
    }
    before = now;
  }
}

TEST(PressureErrors, SeeWhatOnePartIsWrongBy)
{
  const TestSurface surface = line(40);
  const double wrong = 1e-3;
  Eigen::VectorXd p = values(surface, [](const double x) { return 2. + x; });
  EXPECT_LT(pressure_error(surface.partition, p, p).of_parts.maxCoeff(), 1e-20);
  p[20] += wrong;
  const PressureError error = pressure_error(surface.partition, p, p);
  EXPECT_TRUE(error.ends.empty()); // the ends of the stretch are none of contact
  const double length = surface.parts()[20].length;
  EXPECT_NEAR(error.of_parts[20] / (.5 * wrong * wrong * length), 1., 1e-2);
  Index where;
  EXPECT_EQ(error.of_parts.maxCoeff(&where), error.of_parts[20]);
  EXPECT_EQ(where, 20);
  EXPECT_LT(std::max(error.of_parts.head(18).maxCoeff(), error.of_parts.tail(18).maxCoeff()), 1e-20);
}

TEST(PressureErrors, AreNotSaidUnderTheEdgeOfAPunch)
{
  const TestSurface surface = line(40);
  const Eigen::VectorXd p =
      values(surface, [](const double x) { return 1. / std::sqrt(x * (1. - x) + 1e-3); });
  const PressureError error = pressure_error(surface.partition, p, p);
  EXPECT_TRUE(error.is_singular[20]);
  EXPECT_TRUE(error.ends.empty());
  EXPECT_EQ(error.of_parts.maxCoeff(), 0.);
}

TEST(PressureErrors, AreLargeForContactOfFewParts)
{
  const TestSurface surface = line(40);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(41);
  p[20] = 1.;
  const PressureError error = pressure_error(surface.partition, p, p);
  ASSERT_EQ(error.ends.size(), 2u);
  EXPECT_GT(end_error(error), .5 * std::sqrt(surface.parts()[20].length)); // of its own norm
}

TEST(PressureErrors, AreTheSameAllRoundAClosedSide)
{
  const unsigned int n = 40;
  const TestSurface surface(make_arc(1., 0., 2. * M_PI, n, 1), make_arc(1.001, 2. * M_PI, 0., n, 1), 1., 2.);
  ASSERT_TRUE(surface.partition.stretches()[0].closed);
  double first = 0.;
  for (unsigned int turned = 0; turned < n; ++turned)
  {
    Eigen::VectorXd p = Eigen::VectorXd::Zero(n);
    for (unsigned int i = 0; i < 15; ++i)
      p[(turned + i) % n] = std::sqrt(60. - std::pow(i - 7., 2.));
    p[(turned + 7) % n] += .1;
    const PressureError error = pressure_error(surface.partition, p, p);
    ASSERT_EQ(error.ends.size(), 2u);
    const double square = error.of_parts.sum() + std::pow(end_error(error), 2);
    if (turned == 0)
      first = square;
    EXPECT_NEAR(square / first, 1., 1e-9) << turned;
  }
  const Eigen::VectorXd all = Eigen::VectorXd::Ones(n);
  EXPECT_TRUE(pressure_error(surface.partition, all, all).ends.empty());
}
