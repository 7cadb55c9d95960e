// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <string>

namespace abut
{
  /**
   * Stress of one wave divided by the pressure amplitude: sigma_xx = xx cos(lambda x),
   * sigma_yy = yy cos(lambda x), sigma_xy = xy sin(lambda x), tension positive.
   */
  struct WaveStress
  {
    double xx;
    double yy;
    double xy;
  };

  /**
   * Airy function of one wave in a layer 0 <= y <= H, divided by (pressure amplitude)/lambda^2 cos(lambda x):
   *   f(v) = (rising + rising_slope v) exp(v - u) + (falling + falling_slope v) exp(-v - u)
   * with v = lambda y and u = lambda H: exponentials that decay away from the pressed face only.
   */
  struct AiryWave
  {
    double rising;
    double rising_slope;
    double falling;
    double falling_slope;

    /// xx = f'', yy = -f, xy = f' at v, given exp(v - u) and exp(-v - u).
    WaveStress stress(double v, double exp_rising, double exp_falling) const;
    /// The same where the exponentials are not at hand.
    WaveStress stress(double v, double u) const;
  };

  /**
   * An elastic layer 0 <= y <= thickness in plane strain on a rigid face y = 0, pressed on y = thickness by a
   * pressure without friction. Moduli in force per area, lengths in one unit. A pressure p cos(lambda x)
   * presses the surface in by (2(1-nu^2)/E) p L(u)/lambda cos(lambda x), u = lambda H, with
   * [Johnson1985, ch. 5]
   *   sliding base:  L = (cosh 2u - 1)/(sinh 2u + 2u),
   *   bonded base:   L = (2 kappa sinh 2u - 4u)/(2 kappa cosh 2u + 1 + kappa^2 + 4u^2),  kappa = 3 - 4 nu.
   */
  struct Layer
  {
    /// The rigid face holds the layer in its normal direction only, or in both.
    enum class Base
    {
      sliding,
      bonded
    };

    /// What a uniform pressure meets: rollers that forbid lateral strain, or the limit lambda -> 0 of the
    /// waves in a layer without ends.
    enum class Ends
    {
      rollers,
      infinite
    };

    double young_modulus;
    double poisson_ratio;
    double thickness;
    Base base = Base::sliding;

    /// Factor of (pressure amplitude)/lambda in the surface displacement of a half-plane: 2(1-nu^2)/E.
    double half_plane_compliance() const;
    /// Surface displacement under unit uniform pressure: H(1+nu)(1-2nu)/(E(1-nu)) where nothing strains
    /// laterally, H(1-nu^2)/E in an infinite layer on a sliding base.
    double uniform_compliance(Ends ends) const;
    /// sigma_xx/sigma_yy under uniform pressure: nu/(1-nu), or 0 in an infinite layer on a sliding base.
    double uniform_stress_ratio(Ends ends) const;
    /// L(u) - 1: what the rigid face changes in the compliance of the half-plane; decays like exp(-2u).
    double compliance_change(double u) const;

    /**
     * The wave lambda = u/H. Sliding: f = a cosh v + b v sinh v; bonded, with m = 2(1-nu), f = a (cosh v - v
     * sinh v/m) + c ((m-1) sinh v + v cosh v), which has no displacement at v = 0; both with f(u) = 1 and
     * f'(u) = 0 [Timoshenko1970, art. 24].
     */
    AiryWave wave(double u) const;
    /// The same less the wave of a half-plane, f = (1 + u - v) exp(v - u).
    AiryWave wave_change(double u) const;

    /// Waves in the width `length` of a layer with u = lambda H below 40: those the rigid face changes at all
    /// (by more than 1e-15 anywhere in the layer).
    Eigen::Index n_thin_modes(double length) const;

    /**
     * Surface displacement at the points x without that of the mean pressure, column by column: `modes` holds
     * cosine amplitudes of pressures with lambda_k = k pi/length (row 0 the mean, unused), `potential` their
     * sums of p_k cos(lambda_k x)/lambda_k over all k >= 1.
     */
    Eigen::MatrixXd wave_displacement(double length, const Eigen::VectorXd &x, const Eigen::MatrixXd &modes,
                                      const Eigen::MatrixXd &potential) const;

    /// Throws UserError, beginning with `name`, for E <= 0, nu outside (-1, 0.5) or thickness <= 0.
    void check(const std::string &name) const;

  private:
    bool strains_laterally(Ends ends) const;
  };
} // namespace abut
