// SPDX-License-Identifier: LGPL-2.1-or-later
// Piecewise polynomial pressures: potentials against series and integrals over the periodic kernel.
#include <abut/base/user_error.h>
#include <abut/reference/piecewise_pressure.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include "reference_pieces_data.h"
#include <cmath>
#include <complex>
#include <limits>

namespace abut
{
  namespace
  {
    const double pieces_pi = boost::math::constants::pi<double>();

    // int_0^l p f dx, every piece cut at x.
    template <typename Function>
    double integrate_pieces(const std::vector<PressurePiece> &pieces, const Function &f, double x)
    {
      boost::math::quadrature::tanh_sinh<double> quadrature;
      double sum = 0.;
      for (const PressurePiece &piece : pieces)
      {
        const auto density = [&](double s) { return exact_value(piece, s) * f(s); };
        const double cut = std::min(std::max(x, piece.start), piece.end);
        for (const auto &[from, to] : {std::pair(piece.start, cut), std::pair(cut, piece.end)})
          if (from < to)
            sum += quadrature.integrate(density, from, to, 1e-13);
      }
      return sum;
    }
  } // namespace

  TEST(PiecewisePressure, has_the_integrals_of_its_pieces)
  {
    const std::vector<PressurePiece> pieces = rough_pieces();
    const PiecewisePressure pressure(rough_length, pieces);
    EXPECT_NEAR(pressure.force(),
                integrate_pieces(
                    pieces, [](double) { return 1.; }, 0.),
                1e-13);
    const auto own = [&](double x) { return pressure.value(x); };
    EXPECT_NEAR(std::pow(pressure.l2_norm(), 2), integrate_pieces(pieces, own, 0.), 1e-13);
    EXPECT_NEAR(pressure.integrate_against(own), std::pow(pressure.l2_norm(), 2), 1e-12);
    const Eigen::VectorXd modes = pressure.modes(40);
    EXPECT_NEAR(modes(0), pressure.force() / rough_length, 1e-14);
    for (const int k : {1, 2, 7, 40})
    {
      const auto wave = [&](double x) { return std::cos(k * pieces_pi * x / rough_length); };
      EXPECT_NEAR(modes(k), 2. / rough_length * integrate_pieces(pieces, wave, 0.), 1e-13) << "k = " << k;
    }
  }

  TEST(PiecewisePressure, has_the_values_of_its_pieces)
  {
    const std::vector<PressurePiece> pieces = rough_pieces();
    const PiecewisePressure pressure(rough_length, pieces);
    for (const PressurePiece &piece : pieces)
    {
      EXPECT_DOUBLE_EQ(pressure.value(piece.start), piece.coefficients[0]);
      const double middle = 0.5 * (piece.start + piece.end);
      EXPECT_DOUBLE_EQ(pressure.value(middle), exact_value(piece, middle));
      EXPECT_DOUBLE_EQ(pressure.value(-middle), pressure.value(middle));
    }
    EXPECT_EQ(pressure.value(2.), 0.);
    EXPECT_EQ(PiecewisePressure(2., {{0.1, 0.2, {{1., 1., 1., 1.}}}}).value(2.), 0.);
    EXPECT_DOUBLE_EQ(pressure.value(rough_length), exact_value(pieces.back(), rough_length));
  }

  // Groups of pieces are summed by their moments: one polynomial, cut into pieces that shrink towards its
  // end.
  TEST(PiecewisePressure, complex_potential_does_not_feel_how_it_is_cut)
  {
    const auto cubic = [](double x) { return 2. - x + 3. * x * x - 1.5 * x * x * x; };
    const auto piece = [&](double start, double end) {
      const double h = end - start; // Taylor's series in t = (x - start)/h
      return PressurePiece{start,
                           end,
                           {{cubic(start), h * (-1. + 6. * start - 4.5 * start * start),
                             h * h * (3. - 4.5 * start), -1.5 * h * h * h}}};
    };
    std::vector<PressurePiece> pieces;
    double start = 0.;
    for (int i = 0; i < 120; ++i)
    {
      const double end = i == 119 ? 1.2 : start + .1 * (1.2 - start);
      pieces.push_back(piece(start, end));
      start = end;
    }
    const PiecewisePressure whole(4., {piece(0., 1.2)}), cut(4., pieces);
    for (const double x : {0., .3, 1.19999, 1.2001, 1.7, 2.9, 4.})
      for (const double depth : {1e-5, .01, .4, 2.})
      {
        const PeriodicPressure::Potential a = whole.complex_potential(x, depth),
                                          b = cut.complex_potential(x, depth);
        const double allowed = 1e-13 + 1e-16 / std::hypot(x - 1.2, depth); // round-off of places at the jump
        EXPECT_LT(std::abs(a.value - b.value), allowed) << x << ' ' << depth;
        EXPECT_LT(depth * std::abs(a.slope - b.slope), allowed) << x << ' ' << depth;
      }
    EXPECT_LT((whole.modes(60) - cut.modes(60)).cwiseAbs().maxCoeff(), 1e-14);
  }

  TEST(PiecewisePressure, complex_potential_is_its_series)
  {
    const PiecewisePressure pressure(rough_length, rough_pieces());
    const Eigen::VectorXd modes = pressure.modes(40000);
    for (const double depth : {0.003, 0.05, 0.8, 9.})
      for (const double x : {0., 0.1, 0.4, 0.400001, 1., 1.70005, 2.5, 3.1, 3.3, -1.2, 4.1})
      {
        std::complex<double> value = modes(0), slope = 0.;
        for (Eigen::Index k = 1; k < modes.size() && double(k) * depth < 40.; ++k)
        {
          const std::complex<double> wave_number(0., double(k) * pieces_pi / rough_length);
          const std::complex<double> wave = modes(k) * std::exp(wave_number * std::complex<double>(x, depth));
          value += wave;
          slope += wave_number * wave;
        }
        const PeriodicPressure::Potential exact = pressure.complex_potential(x, depth);
        EXPECT_NEAR(std::abs(exact.value - value), 0., 2e-13) << x << ", " << depth;
        EXPECT_NEAR(std::abs(exact.slope - slope) * depth, 0., 2e-13) << x << ", " << depth;
      }
  }

  TEST(PiecewisePressure, complex_potential_is_the_pressure_on_the_surface)
  {
    const PiecewisePressure pressure(rough_length, rough_pieces());
    for (const double x : {0., 0.1, 0.35, 0.4000004, 0.400001, 1., 1.70003, 2.5, 3.1, rough_length})
    {
      EXPECT_NEAR(pressure.complex_potential(x, 0.).value.real(), pressure.value(x), 2e-14) << x;
      EXPECT_NEAR(pressure.complex_potential(x, 1e-13).value.real(), pressure.value(x), 1e-5) << x;
    }
  }

  // -(1/pi) times the integral of p ln(2 sin(pi |x - s|/(2l))) over the period.
  TEST(PiecewisePressure, potential_is_the_integral_over_the_logarithmic_kernel)
  {
    const std::vector<PressurePiece> pieces = rough_pieces();
    const PiecewisePressure pressure(rough_length, pieces);
    for (const double x : {0., 0.1, 0.3, 0.4, 0.400001, 1., 1.7, 2.5, 3.1, rough_length})
    {
      const auto kernel = [&](double s) {
        const double angle = pieces_pi / (2. * rough_length);
        const double smallest = std::numeric_limits<double>::min();
        return std::log(
            std::max(4. * std::abs(std::sin(angle * (x - s)) * std::sin(angle * (x + s))), smallest));
      };
      EXPECT_NEAR(pressure.potential(x), -integrate_pieces(pieces, kernel, x) / pieces_pi, 1e-11) << x;
      EXPECT_DOUBLE_EQ(pressure.potential(-x), pressure.potential(x));
    }
  }

  // Pieces a million times shorter than the period, of the same function.
  TEST(PiecewisePressure, does_not_change_when_it_is_cut_into_short_pieces)
  {
    const PressurePiece whole{0.2, 0.9, {{1., -0.7, 2.1, -1.6}}};
    const PiecewisePressure pressure(rough_length, {whole});
    const double h = 1e-6 * rough_length;
    for (const double cut : {0.4, 0.899})
    {
      std::vector<PressurePiece> pieces{part_of(whole, whole.start, cut)};
      for (int i = 0; i < 50; ++i)
        pieces.push_back(part_of(whole, cut + i * h, cut + (i + 1) * h));
      pieces.push_back(part_of(whole, pieces.back().end, whole.end));
      const PiecewisePressure same(rough_length, pieces);
      for (const double depth : {0., 1e-9, 1e-7, 1e-6, 1e-5, 1e-3, 0.3})
        for (const double x : {cut, cut + 10. * h, cut + 20.3 * h, cut - 3.7 * h, cut + 77. * h, 0., 2.})
        {
          const PeriodicPressure::Potential fine = same.complex_potential(x, depth);
          const PeriodicPressure::Potential coarse = pressure.complex_potential(x, depth);
          EXPECT_NEAR(std::abs(fine.value - coarse.value), 0., 1e-12) << x << ", " << depth;
          EXPECT_NEAR(std::abs(fine.slope - coarse.slope) * depth, 0., 1e-12) << x << ", " << depth;
          EXPECT_NEAR(same.potential(x), pressure.potential(x), 1e-12) << x;
        }
    }
  }

  TEST(PiecewisePressure, refuses_pieces_that_make_no_sense)
  {
    const auto make = [](double start, double end, double value) {
      return PiecewisePressure(1., {{0.2, 0.4, {{1., 0., 0., 0.}}}, {start, end, {{value, 0., 0., 0.}}}});
    };
    EXPECT_NO_THROW(make(0.4, 1., 2.));
    EXPECT_NO_THROW(make(0., 0.2, 2.));
    EXPECT_THROW(make(0.3, 1., 2.), UserError);
    EXPECT_THROW(make(0.5, 1.1, 2.), UserError);
    EXPECT_THROW(make(-0.1, 0.1, 2.), UserError);
    EXPECT_THROW(make(0.6, 0.6, 2.), UserError);
    EXPECT_THROW(make(0.6, 0.7, std::numeric_limits<double>::quiet_NaN()), UserError);
  }
} // namespace abut
