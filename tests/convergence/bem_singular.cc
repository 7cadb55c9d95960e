// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary elements where the stress is infinite at a point of the boundary. With u ~ r^alpha and uniform
// elements the energy norm is of the order alpha, stresses inside (a functional of a dual problem as
// singular) of the order 2 alpha, the L2 norm of u of alpha + 1/2, that of the best approximation.
#include <abut/reference/reentrant_corner.h>

#include <gtest/gtest.h>

#include "bem_orders.h"

using namespace abut;

namespace
{
  /// The L-shape: clamped on the left, free in the notch, tractions elsewhere.
  BoundaryCase l_shape_case(const unsigned int n, const double grading)
  {
    BoundaryCase problem;
    const ReentrantCorner corner(problem.material.young_modulus, problem.material.poisson_ratio, 1.);
    problem.field.displacement = [=](const Complex z) {
      const Vector2 u = corner.displacement({z.real(), z.imag()});
      return Complex(u.x(), u.y());
    };
    problem.field.stress = [=](const Complex z) -> Stress {
      const ExactStress s = corner.stress({z.real(), z.imag()});
      return {s.xx, s.yy, s.xy, s.zz};
    };
    problem.field.traction = traction_of(problem.field.stress);
    problem.curves = {divided({{{-1., -1.}, uniform(n)},
                               {{0., -1.}, graded_to_end(n, grading)},
                               {{0., 0.}, graded_to_start(n, grading)},
                               {{1., 0.}, uniform(n)},
                               {{1., 1.}, uniform(2 * n)},
                               {{-1., 1.}, uniform(2 * n)}})};
    problem.supported = [](const Complex, const Vector2 &normal) -> std::vector<Vector2> {
      if (normal.x() > -.5)
        return {};
      return {Vector2::UnitX(), Vector2::UnitY()};
    };
    problem.points = {{-.4, .3}, {-.3, -.5}, {.5, .4}, {-.2, .2}};
    return problem;
  }

  /**
   * The upper half-plane, held for x < 0 and free for x > 0: with chi = z phi' + psi, phi + conj(chi) = 0 on
   * the free part, k phi - conj(chi) = 0 on the clamped one, which phi = z^a, chi = -z^conj(a) fulfil for
   * exp(2 pi i a) = -1/k, a = 1/2 + i ln(k)/(2 pi).
   */
  Potentials clamped_half(const Complex z, const double k)
  {
    const Complex a(.5, std::log(k) / (2. * M_PI)), b = std::conj(a);
    const Complex log_z = std::log(z / Complex(0., 1.)) + Complex(0., .5 * M_PI);
    const auto power = [&](const Complex exponent) { return std::exp(exponent * log_z); };
    return {power(a), a * power(a - 1.), a * (a - 1.) * power(a - 2.), -power(b) - a * power(a),
            -b * power(b - 1.) - a * a * power(a - 1.)};
  }

  /// The upper half-plane without shear, u_y = 0 for x < 0 and free for x > 0: a crack along x > 0, mode I,
  /// phi' = c z^(-1/2), psi' = -z phi''.
  Potentials rolling_half(const Complex z)
  {
    const Complex c(0., -1.);
    const Complex root =
        std::exp(.5 * (std::log(z / Complex(0., 1.)) + Complex(0., .5 * M_PI))); // arg z from 0 to pi
    return {2. * c * root, c / root, -.5 * c / (root * z), c * root, .5 * c / root};
  }

  /// [-1, 1] x [0, 1], the left half of the bottom supported.
  BoundaryCase half_supported(const unsigned int n, const bool clamped, const double grading,
                              const double poisson_ratio)
  {
    BoundaryCase problem;
    problem.material.poisson_ratio = poisson_ratio;
    const double k = 3. - 4. * poisson_ratio;
    problem.field = from_potentials(problem.material, [=](const Complex z) {
      const Complex place = z == 0. ? Complex(0., 1e-100) : z; // u is 0 there
      return clamped ? clamped_half(place, k) : rolling_half(place);
    });
    problem.curves = {divided({{{-1., 0.}, graded_to_end(n, grading)},
                               {{0., 0.}, graded_to_start(n, grading)},
                               {{1., 0.}, uniform(n)},
                               {{1., 1.}, uniform(2 * n)},
                               {{-1., 1.}, uniform(n)}})};
    problem.supported = [=](const Complex z, const Vector2 &normal) -> std::vector<Vector2> {
      if (normal.y() > -.5 || z.real() > 0.)
        return {};
      if (clamped)
        return {Vector2::UnitX(), Vector2::UnitY()};
      return {Vector2::UnitY()};
    };
    problem.points = {{-.5, .5}, {.4, .6}, {.1, .4}, {-.3, .3}};
    return problem;
  }
} // namespace

TEST(BemSingular, ReentrantCorner)
{
  const double alpha = ReentrantCorner(1., .3, 1.).exponent();
  const ConvergenceTable uniform = study(
      "L-shape, uniform", [](const unsigned int n) { return l_shape_case(n, 1.); }, 4, 5);
  EXPECT_NEAR(uniform.last_rate(displacement), alpha + .5, .1);
  EXPECT_NEAR(uniform.last_rate(stress), 2. * alpha, .1);
  const ConvergenceTable graded = study(
      "L-shape, graded", [](const unsigned int n) { return l_shape_case(n, 3.); }, 4, 4);
  EXPECT_GT(graded.last_rate(displacement), 1.8);
  EXPECT_GT(graded.last_rate(stress), 1.8);
}

TEST(BemSingular, SupportThatEndsInsideASide)
{
  for (const double nu : {.3, .4999999})
    for (const bool clamped : {true, false})
    {
      const std::string title =
          std::string(clamped ? "Clamped" : "On rollers") + " over half a side, nu " + std::to_string(nu);
      const ConvergenceTable uniform = study(
          title, [&](const unsigned int n) { return half_supported(n, clamped, 1., nu); }, 4, 5);
      EXPECT_NEAR(uniform.last_rate(displacement), 1., .1);
      EXPECT_NEAR(uniform.last_rate(stress), 1., .1);
      const ConvergenceTable graded = study(
          title + ", graded", [&](const unsigned int n) { return half_supported(n, clamped, 3., nu); }, 4, 4);
      EXPECT_GT(graded.last_rate(displacement), 1.8);
      EXPECT_GT(graded.last_rate(stress), 1.8);
    }
}
