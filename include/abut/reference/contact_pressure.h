// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/sine_basis.h>

#include <complex>

namespace abut
{
  /**
   * A pressure p(x) = sum_j c_j b_j(x) >= 0 on the contact, continued evenly with the period 2l, and what a
   * half-plane under it feels. Force per area; the shapes b_j are those of SineBasis.
   */
  class ContactPressure
  {
  public:
    /// The sum G(z) = p_0 + sum_k p_k exp(i lambda_k z) and its derivative.
    struct Potential
    {
      std::complex<double> value;
      std::complex<double> slope;
    };

    ContactPressure(const SineBasis &basis, const Eigen::VectorXd &coefficients);

    double half_width() const { return basis_.half_width(); }
    double value(double x) const { return basis_.values(x) * coefficients_; }
    /// int_0^l p dx: one half of the contact.
    double force() const;
    /// sqrt(int_0^l p^2 dx)
    double l2_norm() const;
    /// int_0^l p f dx for f even and smooth on the contact.
    template <typename Function> double integrate_against(const Function &f) const;
    /// p_0 and the factors p_k of cos(k pi x/l), k = 1 ... n_modes.
    Eigen::VectorXd modes(Eigen::Index n_modes) const { return basis_.modes(n_modes) * coefficients_; }
    /// sum_{k>=1} p_k cos(lambda_k x)/lambda_k
    double potential(double x) const { return basis_.potential(x) * coefficients_; }

    /**
     * G at x + i d, d >= 0 the depth under the surface: G = i/(2l) int p(s) cot(pi (z - s)/(2l)) ds. The pole
     * is integrated in closed form, int sqrt(1-t^2) U_k(t)/(tau - t) dt = pi rho^-(k+1) with rho = tau +
     * sqrt(tau^2 - 1), the rest by Gauss-Chebyshev. On the surface (d = 0) the slope is not computed and
     * returned as zero: it is infinite at the edge of contact, and only d times it is a stress.
     */
    Potential complex_potential(double x, double depth) const;

  private:
    Potential pole_part(std::complex<double> z) const;
    Potential image_part(std::complex<double> z) const;

    SineBasis basis_;
    Eigen::VectorXd coefficients_;
    Eigen::VectorXd weighted_;          // p(x_q) times the weight of the node x_q
    Eigen::VectorXcd node_exponential_; // exp(-i pi x_q/l)
  };

  template <typename Function> double ContactPressure::integrate_against(const Function &f) const
  {
    return 0.5 * weighted_.dot(basis_.nodes().unaryExpr(f));
  }
} // namespace abut
