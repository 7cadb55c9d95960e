// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/reference/contact_pressure.h>
#include <abut/reference/periodic_kernel.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Complex = std::complex<double>;
    constexpr double contact_pressure_pi = boost::math::constants::pi<double>();
    constexpr Complex imaginary_unit(0., 1.);
    constexpr double smallest_decay = 39.; // exp(-39) = 1e-17

    // int_0^pi cos(2 k angle) sin(angle) d angle
    double cosine_moment(const Eigen::Index k)
    {
      return 2. / (1. - 4. * double(k) * double(k));
    }
  } // namespace

  ContactPressure::ContactPressure(const SineBasis &basis, const Eigen::VectorXd &coefficients)
      : basis_(basis), coefficients_(coefficients), weighted_(basis.quadrature() * coefficients)
  {
    AssertDimension(coefficients_.size(), basis_.size());
    find_image_weights();
  }

  // The kernel without its pole has none nearer to the contact than l - a, seen from 0 <= x <= l: it is
  // interpolated at Chebyshev nodes, with an error of rho^-n for n of them.
  void ContactPressure::find_image_weights()
  {
    const double ratio = basis_.length() / half_width();
    const double decay = std::log(ratio + std::sqrt((ratio - 1.) * (ratio + 1.)));
    const auto wanted = static_cast<Eigen::Index>(std::ceil(smallest_decay / decay)) + 2;
    const Eigen::Index n = std::min(wanted, basis_.nodes().size());
    const auto chebyshev = [](const Eigen::VectorXd &angles, const Eigen::Index k) -> Eigen::ArrayXd {
      return (double(k) * angles.array()).cos();
    };
    const Eigen::VectorXd from_angles = (basis_.nodes() / half_width()).array().acos();
    Eigen::VectorXd angles(n);
    for (Eigen::Index q = 0; q < n; ++q)
      angles(q) = (double(q) + .5) * contact_pressure_pi / double(n);
    image_nodes_ = half_width() * chebyshev(angles, 1);
    image_weights_ = Eigen::VectorXd::Zero(n);
    for (Eigen::Index k = 0; k < n; ++k)
      image_weights_.array() += (k == 0 ? 1. : 2.) / double(n) *
                                weighted_.dot(chebyshev(from_angles, k).matrix()) * chebyshev(angles, k);
    node_exponential_ =
        (-imaginary_unit * contact_pressure_pi / basis_.length() * image_nodes_).array().exp();
  }

  double ContactPressure::force() const
  {
    return 0.25 * contact_pressure_pi * half_width() * coefficients_(0);
  }

  double ContactPressure::l2_norm() const
  {
    double sum = 0.;
    for (Eigen::Index i = 0; i < basis_.size(); ++i)
      for (Eigen::Index j = 0; j < basis_.size(); ++j)
        sum += coefficients_(i) * coefficients_(j) * 0.5 * (cosine_moment(i - j) - cosine_moment(i + j + 1));
    return std::sqrt(0.5 * half_width() * sum);
  }

  double ContactPressure::integrate_against(const std::function<double(double)> &f) const
  {
    return 0.5 * weighted_.dot(basis_.nodes().unaryExpr(f));
  }

  ContactPressure::Potential ContactPressure::complex_potential(const double x, const double depth) const
  {
    const Complex z(x, depth);
    const Potential pole = pole_part(z);
    const Potential images = image_part(z);
    if (depth <= 0.)
      return {pole.value + images.value, 0.};
    return {pole.value + images.value, pole.slope + images.slope};
  }

  ContactPressure::Potential ContactPressure::pole_part(const Complex z) const
  {
    const Complex tau = z / half_width();
    const Complex root = std::sqrt(tau - 1.) * std::sqrt(tau + 1.);
    const Complex inverse = 1. / (tau + root);
    Complex power = inverse;
    Potential sum{0., 0.};
    for (Eigen::Index j = 0; j < basis_.size(); ++j)
    {
      sum.value += coefficients_(j) * power;
      sum.slope += coefficients_(j) * double(2 * j + 1) * power;
      power *= inverse * inverse;
    }
    return {imaginary_unit * sum.value, -imaginary_unit * sum.slope / (half_width() * root)};
  }

  ContactPressure::Potential ContactPressure::image_part(const Complex z) const
  {
    const double to_angle = contact_pressure_pi / (2. * basis_.length());
    const Complex exponential = std::exp(2. * imaginary_unit * to_angle * z);
    Potential sum{0., 0.};
    for (Eigen::Index q = 0; q < image_weights_.size(); ++q)
    {
      const CotangentRest part =
          cotangent_without_pole(to_angle * (z - image_nodes_(q)), exponential * node_exponential_(q));
      sum.value += image_weights_(q) * part.value;
      sum.slope += image_weights_(q) * part.slope;
    }
    const Complex factor = imaginary_unit / (2. * basis_.length());
    return {factor * sum.value, factor * to_angle * sum.slope};
  }
} // namespace abut
