// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/reference/legendre_second_kind.h>
#include <abut/reference/piecewise_pressure.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double pieces_pi = boost::math::constants::pi<double>();

    double evaluate_piece(const PressurePiece &piece, const double t)
    {
      const std::array<double, 4> &c = piece.coefficients;
      return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    }

    // From powers on [0, 1] to Legendre polynomials on [-1, 1].
    std::array<double, 4> to_legendre(const std::array<double, 4> &c)
    {
      return {{c[0] + c[1] / 2. + c[2] / 3. + c[3] / 4., c[1] / 2. + c[2] / 2. + 9. * c[3] / 20.,
               c[2] / 6. + c[3] / 4., c[3] / 20.}};
    }

    // P_n(-t) = (-1)^n P_n(t)
    std::array<double, 4> mirrored(const std::array<double, 4> &legendre)
    {
      return {{legendre[0], -legendre[1], legendre[2], -legendre[3]}};
    }

    bool is_zero(const PressurePiece &piece)
    {
      return piece.coefficients == std::array<double, 4>{};
    }

    void check_piece(const PressurePiece &piece, const double length, const double previous_end)
    {
      const std::array<double, 4> &c = piece.coefficients;
      std::ostringstream message;
      if (!(piece.start >= 0. && piece.start < piece.end && piece.end <= length))
        message << "A piece of pressure reaches from " << piece.start << " to " << piece.end
                << ", which must increase within 0 and " << length << ".";
      else if (piece.start < previous_end)
        message << "A piece of pressure begins at " << piece.start
                << ", which must not be left of the end of the one before, " << previous_end << ".";
      else if (!std::all_of(c.begin(), c.end(), [](double value) { return std::isfinite(value); }))
        message << "The piece of pressure from " << piece.start << " to " << piece.end
                << " has a coefficient that is not finite.";
      if (!message.str().empty())
        throw UserError(message.str());
    }

    // ln|x|, large and finite at 0 as in legendre_second_kind.
    double logarithm_of(const double x)
    {
      return 0.5 * std::log(std::max(x * x, std::numeric_limits<double>::min()));
    }

    // Moments for MirrorRest, exact.
    Eigen::VectorXd moments_of(const std::vector<PressurePiece> &pieces, const double length)
    {
      using Gauss = boost::math::quadrature::gauss<double, 20>;
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(MirrorRest::n_moments);
      for (const PressurePiece &piece : pieces)
      {
        const double width = piece.end - piece.start;
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
          for (const double sign : {-1., 1.})
          {
            const double t = 0.5 * (1. + sign * Gauss::abscissa()[i]);
            const double x = piece.start + width * t;
            sum += 0.5 * width * Gauss::weights()[i] * evaluate_piece(piece, t) *
                   legendre_polynomials(MirrorRest::n_moments, 2. * x / length - 1.);
          }
      }
      return sum;
    }

    void add_with_images(const PressurePiece &piece, const double length,
                         std::vector<PressureSegment> &segments)
    {
      const std::array<double, 4> legendre = to_legendre(piece.coefficients);
      segments.push_back({0., piece.start, piece.end, legendre});
      segments.push_back({0., -piece.end, -piece.start, mirrored(legendre)});
      segments.push_back({length, length - piece.end, length - piece.start, mirrored(legendre)});
    }

    /// j_0 ... j_3 for x > 0: series below 1, where the closed forms cancel.
    std::array<double, 4> spherical_bessel(const double x)
    {
      std::array<double, 4> j{};
      if (x >= 1.)
      {
        j[0] = std::sin(x) / x;
        j[1] = (j[0] - std::cos(x)) / x;
        for (std::size_t n = 1; n < 3; ++n)
          j[n + 1] = double(2 * n + 1) / x * j[n] - j[n - 1];
        return j;
      }
      double first = 1.; // x^n/(2n+1)!!
      for (std::size_t n = 0; n < 4; ++n)
      {
        double term = first;
        for (int i = 1; i <= 10; ++i)
        {
          j[n] += term;
          term *= -.5 * x * x / (i * double(2 * n + 2 * std::size_t(i) + 1));
        }
        first *= x / double(2 * n + 3);
      }
      return j;
    }

    std::vector<PressurePiece> checked_pieces(std::vector<PressurePiece> pieces, const double length)
    {
      const auto is_left = [](const PressurePiece &a, const PressurePiece &b) { return a.start < b.start; };
      std::sort(pieces.begin(), pieces.end(), is_left);
      double previous_end = 0.;
      for (const PressurePiece &piece : pieces)
      {
        check_piece(piece, length, previous_end);
        previous_end = piece.end;
      }
      pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_zero), pieces.end());
      return pieces;
    }
  } // namespace

  PiecewisePressure::PiecewisePressure(const double length, const std::vector<PressurePiece> &pieces)
      : length_(length), pieces_(checked_pieces(pieces, length)), rest_(length, moments_of(pieces_, length))
  {
    std::vector<PressureSegment> segments;
    for (const PressurePiece &piece : pieces_)
      add_with_images(piece, length, segments);
    poles_ = PoleSum(std::move(segments));
  }

  double PiecewisePressure::value(const double x) const
  {
    const double inside = std::abs(std::remainder(x, 2. * length_));
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece)
      if (piece->start <= inside)
      {
        const bool within = inside < piece->end || (inside == length_ && piece->end == length_);
        return within ? evaluate_piece(*piece, (inside - piece->start) / (piece->end - piece->start)) : 0.;
      }
    return 0.;
  }

  double PiecewisePressure::force() const
  {
    double sum = 0.;
    for (const PressurePiece &piece : pieces_)
      sum += (piece.end - piece.start) * to_legendre(piece.coefficients)[0];
    return sum;
  }

  double PiecewisePressure::l2_norm() const
  {
    double sum = 0.;
    for (const PressurePiece &piece : pieces_)
    {
      const std::array<double, 4> c = to_legendre(piece.coefficients);
      sum +=
          (piece.end - piece.start) * (c[0] * c[0] + c[1] * c[1] / 3. + c[2] * c[2] / 5. + c[3] * c[3] / 7.);
    }
    return std::sqrt(sum);
  }

  double PiecewisePressure::integrate_against(const std::function<double(double)> &f) const
  {
    boost::math::quadrature::tanh_sinh<double> quadrature(8);
    double sum = 0.;
    for (const PressurePiece &piece : pieces_)
    {
      const double width = piece.end - piece.start;
      const auto density = [&](double t) {
        return width * evaluate_piece(piece, t) * f(piece.start + width * t);
      };
      sum += quadrature.integrate(density, 0., 1., 1e-12);
    }
    return sum;
  }

  // int_{-1}^{1} P_n(t) exp(i omega t) dt = 2 i^n j_n(omega)
  Eigen::VectorXd PiecewisePressure::modes(const Eigen::Index n_modes) const
  {
    Assert(n_modes >= 0, dealii::ExcMessage("a number of modes is not negative"));
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n_modes + 1);
    result(0) = force() / length_;
    for (const PressurePiece &piece : pieces_)
    {
      const double half = 0.5 * (piece.end - piece.start);
      const std::array<double, 4> c = to_legendre(piece.coefficients);
      for (Eigen::Index k = 1; k <= n_modes; ++k)
      {
        const double lambda = double(k) * pieces_pi / length_;
        const double phase = lambda * (piece.start + half);
        const std::array<double, 4> bessel = spherical_bessel(lambda * half);
        result(k) += 4. * half / length_ *
                     (std::cos(phase) * (c[0] * bessel[0] - c[2] * bessel[2]) -
                      std::sin(phase) * (c[1] * bessel[1] - c[3] * bessel[3]));
      }
    }
    return result;
  }

  double PiecewisePressure::potential(const double x) const
  {
    const double inside = std::abs(std::remainder(x, 2. * length_));
    double sum = 0.;
    for (const PressureSegment &segment : poles_.segments())
    {
      const double from_start = inside - segment.origin - segment.start;
      const double from_end = inside - segment.origin - segment.end;
      const LegendreSecondKind q = legendre_second_kind(from_start, from_end);
      const std::array<double, 4> &c = segment.legendre;
      double part = c[0] * (logarithm_of(from_start) + logarithm_of(from_end) + 2. * q[1].real());
      for (std::size_t n = 1; n < 4; ++n)
        part += c[n] * 2. / double(2 * n + 1) * (q[n + 1].real() - q[n - 1].real());
      sum += 0.5 * (segment.end - segment.start) * part;
    }
    return rest_.potential(inside) - sum / pieces_pi;
  }

  PeriodicPressure::Potential PiecewisePressure::complex_potential(const double x, const double depth) const
  {
    Assert(depth >= 0., dealii::ExcMessage("a depth is measured downwards"));
    const double inside = std::remainder(x, 2. * length_);
    const std::complex<double> z(std::abs(inside), depth);
    const Potential poles = poles_(z);
    const Potential rest = rest_.complex_potential(z);
    const std::complex<double> value = poles.value + rest.value;
    const std::complex<double> slope = depth > 0. ? poles.slope + rest.slope : 0.;
    if (inside < 0.) // p is even: G(-conj z) = conj G(z)
      return {std::conj(value), -std::conj(slope)};
    return {value, slope};
  }
} // namespace abut
