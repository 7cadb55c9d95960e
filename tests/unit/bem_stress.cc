// SPDX-License-Identifier: LGPL-2.1-or-later
// Interior stress of a single element with arbitrary values, against quadrature in extended precision.
#include <abut/base/lagrange_basis.h>
#include <abut/bem/interior_stress.h>

#include <gtest/gtest.h>

#include "bem_exact_field.h"
#include <algorithm>
#include <cmath>

using namespace abut;

namespace
{
  using Long = long double;
  using LongComplex = std::complex<Long>;

  const BoundaryElement element({.1, .2}, {.13, .24});
  constexpr double shear_modulus = .8, poisson_ratio = .3;

  LongComplex extended(const Complex z)
  {
    return {z.real(), z.imag()};
  }

  /// Values of the given degrees, different for each seed, of size 1.
  BoundaryValues arbitrary_values(const unsigned int traction_degree, const unsigned int slope_degree)
  {
    std::srand(7);
    return {Eigen::MatrixXcd::Random(traction_degree + 1, 1), Eigen::MatrixXcd::Random(slope_degree + 1, 1)};
  }

  LongComplex series(const Eigen::MatrixXcd &coefficients, const Long eta)
  {
    LongComplex sum = 0.;
    for (unsigned int n = 0; n < coefficients.rows(); ++n)
      sum += extended(coefficients(n, 0)) * std::legendre(n, std::clamp(eta, Long(-1), Long(1)));
    return sum;
  }

  /**
   * The integrals of InteriorStress by composite Gauss rules in v, eta = foot + distance sinh v, where the
   * foot is the place on the element closest to z: the integrand is smooth in v at any distance.
   */
  class Reference
  {
  public:
    Reference(const BoundaryValues &values, const Complex z) : values_(values)
    {
      const LongComplex half = .5L * (extended(element.end) - extended(element.start));
      const LongComplex x = (extended(z) - extended(element.start)) / half - 1.L;
      const Long foot = std::clamp(x.real(), Long(-1), Long(1)), distance = std::abs(x - foot);
      const Long first = std::asinh((-1 - foot) / distance), last = std::asinh((1 - foot) / distance);
      const int n_panels = static_cast<int>(std::ceil(last - first));
      const GaussRule gauss(24);
      for (int panel = 0; panel < n_panels; ++panel)
        for (Eigen::Index j = 0; j < gauss.points.size(); ++j)
        {
          const Long v = first + (last - first) * (panel + Long(gauss.points[j])) / n_panels;
          const Long d_eta = (last - first) / n_panels * Long(gauss.weights[j]) * distance * std::cosh(v);
          const LongComplex w = half * (distance * std::sinh(v) - (x - foot));
          add(foot + distance * std::sinh(v), w, std::abs(half) * d_eta);
        }
    }

    Stress stress() const
    {
      const Long pi = std::acos(Long(-1));
      const LongComplex i(0, 1);
      const Long trace = (4.L * q_sum_ / (2.L * pi * i)).real();
      const LongComplex deviator = p_sum_ / (pi * i);
      return {double((trace - deviator.real()) / 2), double((trace + deviator.real()) / 2),
              double(deviator.imag() / 2), poisson_ratio * double(trace)};
    }

  private:
    void add(const Long eta, const LongComplex w, const Long ds)
    {
      const LongComplex i(0, 1), t = series(values_.traction, eta), g = series(values_.slope, eta);
      const LongComplex q = (i * t + 2 * Long(shear_modulus) * g) / (4 - 4 * Long(poisson_ratio));
      const LongComplex p = -i * std::conj(t) - std::conj(q);
      q_sum_ += ds * q / w;
      p_sum_ += ds * (p / w - std::conj(w) * q / (w * w));
    }

    BoundaryValues values_;
    LongComplex q_sum_ = 0., p_sum_ = 0.;
  };

  /// The error relative to the stress.
  double relative_error(const BoundaryValues &values, const Complex z)
  {
    const InteriorStress interior({element}, values, shear_modulus, poisson_ratio);
    const Stress reference = Reference(values, z).stress();
    return stress_distance(interior.at(z), reference) / stress_distance(reference, Stress());
  }

  /// The same from the midpoint at a distance in lengths, the worst of several directions.
  double worst_error_around(const BoundaryValues &values, const double distance)
  {
    double worst = 0.;
    for (const double angle : {.2, 1.1, 1.57, 2.4, 3.14, 4., 4.9, 6.})
      worst = std::max(
          worst, relative_error(values, element.point(0.) + std::polar(distance * element.length, angle)));
    return worst;
  }

  // Closed form near the element: some ten roundings, times what the recurrence of degree 4 amplifies them
  // by.
  constexpr double near_tolerance = 1e-13;
  // StressRules promises 5e-13 for each component of each coefficient, of which two may add up.
  constexpr double far_tolerance = 1e-12;
} // namespace

TEST(BemStress, IsExactAboveAnElementAtAnyDistance)
{
  for (unsigned int degree = 0; degree <= max_density_degree; ++degree)
    for (const double eta : {-1., -.999999, -.7, 0., .3, .98, 1.})
      for (int power = 1; power <= 12; ++power)
        for (const double side : {1., -1.})
        {
          const Complex offset(0., side * std::pow(10., -power) * element.length);
          const Complex z = element.point(eta) + offset * element.direction;
          EXPECT_LT(relative_error(arbitrary_values(degree, degree), z), near_tolerance)
              << degree << " " << eta << " " << offset;
        }
}

TEST(BemStress, IsExactBeyondTheEndsOfAnElementOnItsLine)
{
  for (unsigned int degree = 0; degree <= max_density_degree; ++degree)
    for (int power = 1; power <= 12; ++power)
    {
      const Complex step = std::pow(10., -power) * (element.end - element.start);
      for (const Complex z : {element.start - step, element.end + step})
        EXPECT_LT(relative_error(arbitrary_values(degree, degree), z), near_tolerance)
            << degree << " " << power;
    }
}

TEST(BemStress, HoldsOnBothSidesOfEverySwitch)
{
  for (unsigned int degree = 0; degree <= max_density_degree; ++degree)
  {
    const StressRules rules(degree);
    std::vector<double> switches{rules.closed_distance};
    for (const StressRules::Rule &rule : rules.rules)
      switches.push_back(rule.from_distance);
    EXPECT_EQ(*std::min_element(switches.begin(), switches.end()), rules.closed_distance);
    for (const double distance : switches)
      for (const double factor : {1. - 1e-6, 1. + 1e-6})
        EXPECT_LT(worst_error_around(arbitrary_values(degree, degree), factor * distance), far_tolerance)
            << degree << " " << distance << " " << factor;
  }
}

TEST(BemStress, HoldsFromOneLengthToTenMillions)
{
  for (unsigned int degree = 0; degree <= max_density_degree; ++degree)
    for (double distance = 1.; distance < 1.1e7; distance *= std::sqrt(10.))
      EXPECT_LT(worst_error_around(arbitrary_values(degree, degree), distance), far_tolerance)
          << degree << " " << distance;
}

TEST(BemStress, TakesTractionsAndSlopesOfDifferentDegrees)
{
  for (const double distance : {.7, 30.})
  {
    EXPECT_LT(worst_error_around(arbitrary_values(0, 3), distance), far_tolerance);
    EXPECT_LT(worst_error_around(arbitrary_values(2, 1), distance), far_tolerance);
  }
}

TEST(BemStress, RefusesValuesThatDoNotFit)
{
  const auto construct = [](const Eigen::Index traction_rows, const Eigen::Index columns) {
    const BoundaryValues values{Eigen::MatrixXcd::Zero(traction_rows, columns), Eigen::MatrixXcd::Zero(2, 1)};
    InteriorStress({element}, values, shear_modulus, poisson_ratio);
  };
  EXPECT_NO_THROW(construct(2, 1));
  EXPECT_THROW(construct(2, 2), std::invalid_argument);
  EXPECT_THROW(construct(0, 1), std::invalid_argument);
  EXPECT_THROW(construct(max_density_degree + 2, 1), std::invalid_argument);
}
