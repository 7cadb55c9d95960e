// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/periodic_pressure.h>
#include <abut/reference/sine_basis.h>

namespace abut
{
  /**
   * A pressure p(x) = sum_j c_j b_j(x) on a contact [0, a] that vanishes at its edge like a square root; the
   * shapes b_j are those of SineBasis. `integrate_against` takes functions that are smooth on the contact.
   */
  class ContactPressure : public PeriodicPressure
  {
  public:
    ContactPressure(const SineBasis &basis, const Eigen::VectorXd &coefficients);

    double half_width() const { return basis_.half_width(); }

    double length() const override { return basis_.length(); }
    double value(double x) const override { return basis_.values(x) * coefficients_; }
    double force() const override;
    double l2_norm() const override;
    double integrate_against(const std::function<double(double)> &f) const override;
    Eigen::VectorXd modes(Eigen::Index n_modes) const override
    {
      return basis_.modes(n_modes) * coefficients_;
    }
    double potential(double x) const override { return basis_.potential(x) * coefficients_; }
    /**
     * The pole is integrated in closed form, int sqrt(1-t^2) U_k(t)/(tau - t) dt = pi rho^-(k+1) with rho =
     * tau + sqrt(tau^2 - 1), the rest of the kernel by Gauss-Chebyshev.
     */
    Potential complex_potential(double x, double depth) const override;

  private:
    void find_image_weights();
    Potential pole_part(std::complex<double> z) const;
    Potential image_part(std::complex<double> z) const;

    SineBasis basis_;
    Eigen::VectorXd coefficients_;
    Eigen::VectorXd weighted_;                    // p(x_q) times the weight of the node x_q
    Eigen::VectorXd image_nodes_, image_weights_; // for the kernel without its pole
    Eigen::VectorXcd node_exponential_;           // exp(-i pi x_q/l) of them
  };
} // namespace abut
