// SPDX-License-Identifier: LGPL-2.1-or-later
#include "estimator_fields.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{
  using Number = std::complex<double>;
  using Matrix4 = Eigen::Matrix4cd;

  constexpr Number unit(0., 1.);

  double kappa_of(const abut::Material &material)
  {
    return 3. - 4. * material.poisson_ratio;
  }

  /// r^(1 - l) times free traction at theta = 0 and displacement at `angle`, of (a, conj b, c, conj d).
  Matrix4 wedge_matrix(const Number l, const double kappa, const double angle)
  {
    Matrix4 matrix = Matrix4::Zero();
    int row = 0;
    for (const auto &[theta, first, second] :
         {std::tuple<double, double, double>{0., 1., 1.}, {angle, kappa, -1.}})
    {
      const Number turn = std::exp(unit * theta * l), back = std::exp(-unit * theta * l);
      const Number out = std::exp(2. * unit * theta), in = std::exp(-2. * unit * theta);
      matrix.row(row++) << first * turn, second * l * out * back, 0., second * back;
      matrix.row(row++) << second * l * in * turn, first * back, second * turn, 0.;
    }
    return matrix;
  }

  Number newton(Number l, const double kappa, const double angle)
  {
    const auto value = [&](const Number at) { return wedge_matrix(at, kappa, angle).determinant(); };
    for (int i = 0; i < 50; ++i)
    {
      const double step = 1e-6;
      const Number change = value(l) * 2. * step / (value(l + step) - value(l - step));
      l -= change;
      if (std::abs(change) < 1e-14)
        break;
    }
    return l;
  }
} // namespace

PlaneField field_of(const abut::Material &material, const std::function<Potentials(Number)> &potentials)
{
  const double kappa = kappa_of(material), mu = material.mu(), nu = material.poisson_ratio;
  return {[=](const abut::Vector2 &point) -> abut::Vector2 {
            const Number z(point.x(), point.y());
            const Potentials p = potentials(z);
            const Number u = (kappa * p.phi - z * std::conj(p.d_phi) - std::conj(p.psi)) / (2. * mu);
            return {u.real(), u.imag()};
          },
          [=](const abut::Vector2 &point) -> abut::Stress {
            const Number z(point.x(), point.y());
            const Potentials p = potentials(z);
            const double sum = 4. * p.d_phi.real();
            const Number difference = 2. * (std::conj(z) * p.d2_phi + p.d_psi);
            return {.5 * (sum - difference.real()), .5 * (sum + difference.real()), .5 * difference.imag(),
                    nu * sum};
          }};
}

PlaneField smooth_field(const abut::Material &material)
{
  const Number a(.7, .4), c(1.1, -.8), b(-.5, .9), d(.6, 1.2);
  return field_of(material, [=](const Number z) -> Potentials {
    const Number first = a * std::exp(c * z), second = b * std::exp(d * z);
    return {first, c * first, c * c * first, second, d * second};
  });
}

ClampedWedge::ClampedWedge(const abut::Material &material, const double angle) : material_(material)
{
  const double pi = std::acos(-1.), kappa = kappa_of(material);
  const Number start = angle > .75 * pi ? Number(.5, std::log(kappa) / (2. * pi)) : Number(.75, 0.);
  exponent_ = newton(start, kappa, angle);
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(wedge_matrix(exponent_, kappa, angle), Eigen::ComputeFullV);
  const Eigen::Vector4cd null = std::exp(.3 * unit) * svd.matrixV().col(3);
  a_ = null[0];
  b_ = std::conj(null[1]);
  c_ = null[2];
  d_ = std::conj(null[3]);
}

PlaneField ClampedWedge::field() const
{
  return field_of(material_, [*this](const Number z) -> Potentials {
    const Number l = exponent_, m = std::conj(exponent_);
    const Number place(z.real(), std::max(z.imag(), 0.)); // the branch of the upper half-plane
    if (place == 0.)
      return {};
    const Number first = std::exp(l * std::log(place)), second = std::exp(m * std::log(place));
    const Number d_phi = (a_ * l * first + b_ * m * second) / place;
    return {a_ * first + b_ * second, d_phi,
            (a_ * l * (l - 1.) * first + b_ * m * (m - 1.) * second) / (place * place),
            c_ * first + d_ * second, (c_ * l * first + d_ * m * second) / place};
  });
}
