// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/mirror_rest.h>
#include <abut/reference/periodic_kernel.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double mirror_pi = boost::math::constants::pi<double>();

    // cot without its poles at 0 and pi, for 0 <= Re angle <= pi.
    CotangentRest cotangent_without_two_poles(const std::complex<double> angle,
                                              const std::complex<double> exponential)
    {
      const bool near_first = angle.real() <= 0.5 * mirror_pi;
      const std::complex<double> shifted = angle - mirror_pi;
      const CotangentRest rest = cotangent_without_pole(near_first ? angle : shifted, exponential);
      const std::complex<double> far = near_first ? shifted : angle;
      const std::complex<double> other = std::conj(far) / std::norm(far);
      return {rest.value - other, rest.slope + other * other};
    }
  } // namespace

  MirrorRest::MirrorRest(const double length, const Eigen::VectorXd &moments)
      : length_(length), nodes_(n_moments), weighted_(n_moments)
  {
    Assert(length > 0., dealii::ExcMessage("a length is positive"));
    AssertDimension(moments.size(), static_cast<Eigen::Index>(n_moments));
    using Gauss = boost::math::quadrature::gauss<double, n_moments>;
    for (Eigen::Index q = 0; q < n_moments; ++q)
    {
      const auto pair = std::size_t(q / 2);
      const double t = (q % 2 == 0 ? 1. : -1.) * Gauss::abscissa()[pair];
      nodes_(q) = 0.5 * length * (1. + t);
      const Eigen::VectorXd legendre = legendre_polynomials(n_moments, t);
      weighted_(q) = 0.;
      for (Eigen::Index n = 0; n < n_moments; ++n)
        weighted_(q) += Gauss::weights()[pair] * (double(n) + 0.5) * legendre(n) * moments(n);
    }
    node_exponential_ = (std::complex<double>(0., -mirror_pi / length_) * nodes_).array().exp();
  }

  // ln(2 sin(pi e/(2l))) = ln e + ln(pi/l) + ln sinc for the distance e of a pole; of the two poles of the
  // mirror image, at the distances e and 2l - e, the nearer one is split off like this.
  double MirrorRest::potential(const double x) const
  {
    const double to_angle = mirror_pi / (2. * length_);
    double sum = 0.;
    for (Eigen::Index q = 0; q < n_moments; ++q)
    {
      const double near = std::min(x + nodes_(q), 2. * length_ - x - nodes_(q));
      sum += weighted_(q) * (2. * std::log(mirror_pi / length_) - std::log(2. * length_ - near) -
                             minus_log_sinc(to_angle * (x - nodes_(q))) - minus_log_sinc(to_angle * near));
    }
    return -sum / mirror_pi;
  }

  PeriodicPressure::Potential MirrorRest::complex_potential(const std::complex<double> z) const
  {
    const double to_angle = mirror_pi / (2. * length_);
    const std::complex<double> exponential = std::exp(std::complex<double>(0., 2. * to_angle) * z);
    PeriodicPressure::Potential sum{0., 0.};
    for (Eigen::Index q = 0; q < n_moments; ++q)
    {
      const std::complex<double> node = node_exponential_(q);
      const CotangentRest own = cotangent_without_pole(to_angle * (z - nodes_(q)), exponential * node);
      const CotangentRest image =
          cotangent_without_two_poles(to_angle * (z + nodes_(q)), exponential * std::conj(node));
      sum.value += weighted_(q) * (own.value + image.value);
      sum.slope += weighted_(q) * (own.slope + image.slope);
    }
    const std::complex<double> factor(0., 1. / (2. * length_));
    return {factor * sum.value, factor * to_angle * sum.slope};
  }

  Eigen::VectorXd legendre_polynomials(const Eigen::Index n, const double t)
  {
    Eigen::VectorXd result(n);
    for (Eigen::Index k = 0; k < n; ++k)
      result(k) = k == 0 ? 1.
                  : k == 1
                      ? t
                      : (double(2 * k - 1) * t * result(k - 1) - double(k - 1) * result(k - 2)) / double(k);
    return result;
  }
} // namespace abut
