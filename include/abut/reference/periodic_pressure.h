// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <complex>
#include <functional>

namespace abut
{
  /**
   * A pressure p(x) on the surface of a layer 0 <= x <= l, continued evenly with the period 2l as the mirror
   * images in rollers at the ends do, and what a half-plane under it feels. Force per area, p > 0 presses;
   * with lambda_k = k pi/l it is the cosine series p = p_0 + sum_{k>=1} p_k cos(lambda_k x).
   */
  class PeriodicPressure
  {
  public:
    /// The sum G(z) = p_0 + sum_k p_k exp(i lambda_k z) and its derivative.
    struct Potential
    {
      std::complex<double> value;
      std::complex<double> slope;
    };

    virtual ~PeriodicPressure() = default;

    /// l: half of the period.
    virtual double length() const = 0;
    virtual double value(double x) const = 0;
    /// int_0^l p dx: one half of the period.
    virtual double force() const = 0;
    /// sqrt(int_0^l p^2 dx)
    virtual double l2_norm() const = 0;
    /// int_0^l p f dx for the even f that a displacement under this pressure is.
    virtual double integrate_against(const std::function<double(double)> &f) const = 0;
    /// p_0 and the factors p_k of cos(lambda_k x), k = 1 ... n_modes.
    virtual Eigen::VectorXd modes(Eigen::Index n_modes) const = 0;
    /// sum_{k>=1} p_k cos(lambda_k x)/lambda_k
    virtual double potential(double x) const = 0;
    /**
     * G at x + i d, d >= 0 the depth under the surface: G = i/(2l) int p(s) cot(pi (z - s)/(2l)) ds over a
     * period. A half-plane has yy = -(Re G + d Im G'), xx = -(Re G - d Im G'), xy = -d Re G'. On the surface
     * (d = 0) the slope is not computed and returned as zero: it is infinite where the pressure is not
     * smooth, and only d times it is a stress.
     */
    virtual Potential complex_potential(double x, double depth) const = 0;
  };
} // namespace abut
