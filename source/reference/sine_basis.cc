// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/periodic_kernel.h>
#include <abut/reference/sine_basis.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double sine_basis_pi = boost::math::constants::pi<double>();

    // -int_{-1}^{1} T_k(s) ln|t - s| / sqrt(1 - s^2) ds for even k and any real t.
    double chebyshev_logarithm(Eigen::Index k, double t)
    {
      const double size = std::abs(t);
      if (size <= 1.)
        return k == 0 ? sine_basis_pi * std::log(2.)
                      : sine_basis_pi / double(k) * std::cos(double(k) * std::acos(size));
      const double rho = size + std::sqrt((size - 1.) * (size + 1.));
      return k == 0 ? -sine_basis_pi * std::log(rho / 2.)
                    : sine_basis_pi / double(k) * std::pow(rho, -double(k));
    }

    // J_{2j+1}(z), j = 0 ... n-1. The upward recurrence is stable for orders below z.
    Eigen::RowVectorXd odd_bessel(double z, Eigen::Index n)
    {
      using boost::math::cyl_bessel_j;
      Eigen::RowVectorXd result(n);
      if (z < double(2 * n))
      {
        for (Eigen::Index j = 0; j < n; ++j)
          result(j) = cyl_bessel_j(static_cast<int>(2 * j + 1), z);
        return result;
      }
      double even = cyl_bessel_j(0, z);
      double odd = cyl_bessel_j(1, z);
      for (Eigen::Index j = 0; j < n; ++j)
      {
        result(j) = odd;
        even = double(4 * j + 2) / z * odd - even;
        odd = double(4 * j + 4) / z * even - odd;
      }
      return result;
    }
  } // namespace

  SineBasis::SineBasis(const double half_width, const double length, const Eigen::Index size)
      : half_width_(half_width), length_(length), nodes_(4 * size + 60), quadrature_(4 * size + 60, size)
  {
    Assert(half_width > 0. && half_width < length && size > 0,
           dealii::ExcMessage("a contact ends within the layer and has shapes"));
    const double step = sine_basis_pi / double(nodes_.size() + 1);
    for (Eigen::Index q = 0; q < nodes_.size(); ++q)
    {
      const double angle = step * double(q + 1);
      nodes_(q) = half_width * std::cos(angle);
      for (Eigen::Index j = 0; j < size; ++j)
        quadrature_(q, j) = half_width * step * std::sin(angle) * std::sin(double(2 * j + 1) * angle);
    }
  }

  Eigen::RowVectorXd SineBasis::values(const double x) const
  {
    const double t = std::min(1., std::abs(x) / half_width_);
    const double angle = std::acos(t);
    Eigen::RowVectorXd result(size());
    for (Eigen::Index j = 0; j < size(); ++j)
      result(j) = std::sin(double(2 * j + 1) * angle);
    return result;
  }

  Eigen::MatrixXd SineBasis::modes(const Eigen::Index n_modes) const
  {
    Assert(n_modes >= 0, dealii::ExcMessage("a number of modes is not negative"));
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_modes + 1, size());
    result(0, 0) = sine_basis_pi * half_width_ / (4. * length_);
    for (Eigen::Index k = 1; k <= n_modes; ++k)
    {
      const double z = double(k) * sine_basis_pi * half_width_ / length_;
      const Eigen::RowVectorXd bessel = odd_bessel(z, size());
      for (Eigen::Index j = 0; j < size(); ++j)
        result(k, j) = (j % 2 == 0 ? 1. : -1.) * double(2 * j + 1) * bessel(j) / double(k);
    }
    return result;
  }

  Eigen::RowVectorXd SineBasis::potential(const double x) const
  {
    const double to_angle = sine_basis_pi / (2. * length_);
    const Eigen::RowVectorXd smooth =
        nodes_.unaryExpr([&](double s) { return minus_log_sinc(to_angle * (x - s)); }).transpose();
    Eigen::RowVectorXd result = smooth * quadrature_ / sine_basis_pi;

    const double t = x / half_width_;
    double lower = chebyshev_logarithm(0, t);
    for (Eigen::Index j = 0; j < size(); ++j)
    {
      const double upper = chebyshev_logarithm(2 * j + 2, t);
      result(j) += half_width_ / (2. * sine_basis_pi) * (lower - upper);
      lower = upper;
    }
    result(0) -= 0.5 * half_width_ * std::log(sine_basis_pi * half_width_ / length_);
    return result;
  }
} // namespace abut
