// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace abut::testing
{
  constexpr double layers_ratio = .3; // of Poisson, in both layers

  /// One layer of a strip under cos(k x), by an Airy function f(y) cos(k x), y from its base up to its
  /// height.
  struct StripLayer
  {
    double height, young_modulus;

    double shear_modulus() const { return young_modulus / (2. * (1. + layers_ratio)); }

    /// The n-th derivatives of four functions f, divided by k^n, that grow from the base or from the top.
    Eigen::RowVector4d derivatives(const double k, const double y, const int n) const
    {
      const double sign = n % 2 == 0 ? 1. : -1., up = std::exp(k * (y - height)), down = std::exp(-k * y);
      const double from_top = k * (height - y), from_base = k * y;
      return {up, sign * down, (from_top - n) * up, sign * (from_base - n) * down};
    }
    /// u, v, sigma_yy, sigma_xy at y, divided by sin(k x) or cos(k x) and by k^2 (displacements by k).
    Eigen::Matrix4d state(const double k, const double y) const
    {
      const Eigen::RowVector4d f = derivatives(k, y, 0), f1 = derivatives(k, y, 1), f2 = derivatives(k, y, 2),
                               f3 = derivatives(k, y, 3);
      Eigen::Matrix4d rows;
      rows << ((1. - layers_ratio) * f2 + layers_ratio * f) / (2. * shear_modulus()),
          ((1. - layers_ratio) * f3 - (2. - layers_ratio) * f1) / (2. * shear_modulus()), -f, f1;
      return rows;
    }
  };

  /// sigma_xx on both sides of the glue of two bonded layers on a held base, under a pressure that is a
  /// cosine series.
  class BondedLayers
  {
  public:
    BondedLayers(const StripLayer &base, const StripLayer &coating, const double length)
        : base_(base), coating_(coating), length_(length)
    {}

    /// Adds the pressures of parts [x - w/2, x + w/2].
    void press(const std::vector<double> &x, const std::vector<double> &width,
               const std::vector<double> &pressure)
    {
      const int n_terms = 400;
      below_.assign(n_terms, 0.);
      above_.assign(n_terms, 0.);
      for (int n = 0; n < n_terms; ++n)
      {
        double amplitude = 0.;
        for (std::size_t i = 0; i < x.size(); ++i)
          amplitude += (n == 0 ? 1. : 2.) / length_ * pressure[i] * integral(n, x[i], width[i]);
        add(n, amplitude);
      }
    }
    double below(const double x) const { return sum(below_, x); }
    double above(const double x) const { return sum(above_, x); }

  private:
    double wave(const int n) const { return n * M_PI / length_; }
    double integral(const int n, const double x, const double width) const
    {
      if (n == 0)
        return width;
      const double k = wave(n);
      return (std::sin(k * (x + .5 * width)) - std::sin(k * (x - .5 * width))) / k;
    }
    double sum(const std::vector<double> &terms, const double x) const
    {
      double result = 0.;
      for (std::size_t n = 0; n < terms.size(); ++n)
        result += terms[n] * std::cos(wave(static_cast<int>(n)) * x);
      return result;
    }

    void add(const int n, const double amplitude)
    {
      const auto i = static_cast<std::size_t>(n);
      if (n == 0)
      {
        below_[i] = above_[i] = -amplitude * layers_ratio / (1. - layers_ratio);
        return;
      }
      const double k = wave(n);
      Eigen::Matrix<double, 8, 8> matrix = Eigen::Matrix<double, 8, 8>::Zero();
      matrix.block<2, 4>(0, 0) = base_.state(k, 0.).topRows<2>();
      matrix.block<4, 4>(2, 0) = base_.state(k, base_.height);
      matrix.block<4, 4>(2, 4) = -coating_.state(k, 0.);
      matrix.block<2, 4>(6, 4) = coating_.state(k, coating_.height).bottomRows<2>();
      matrix.topRows<2>() *= base_.shear_modulus();
      matrix.middleRows<2>(2) *= base_.shear_modulus();
      Eigen::Matrix<double, 8, 1> right = Eigen::Matrix<double, 8, 1>::Zero();
      right[6] = -amplitude;
      const Eigen::Matrix<double, 8, 1> solution = matrix.fullPivLu().solve(right);
      below_[i] = base_.derivatives(k, base_.height, 2) * solution.head<4>();
      above_[i] = coating_.derivatives(k, 0., 2) * solution.tail<4>();
    }

    StripLayer base_, coating_;
    double length_;
    std::vector<double> below_, above_;
  };
} // namespace abut::testing
