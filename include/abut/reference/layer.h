// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <string>

namespace abut
{
  /**
   * An elastic layer 0 <= y <= thickness in plane strain on a frictionless rigid face y = 0, pressed on
   * y = thickness by a pressure p cos(lambda x) without friction. Moduli in force per area, lengths in one
   * unit.
   */
  struct Layer
  {
    double young_modulus;
    double poisson_ratio;
    double thickness;

    /// Factor of (pressure amplitude)/lambda in the surface displacement of a half-plane: 2(1-nu^2)/E.
    double half_plane_compliance() const;
    /// Surface displacement under unit uniform pressure, no lateral strain: H(1+nu)(1-2nu)/(E(1-nu)).
    double uniform_compliance() const;
    /// L(u) - 1 with L(u) = (cosh 2u - 1)/(sinh 2u + 2u), u = lambda H: what the rigid face changes in the
    /// compliance of the half-plane. About -2(1+2u) exp(-2u) for large u.
    static double compliance_change(double u);

    /// Waves in the width `length` of a layer with u = lambda H below 40: those the rigid face changes at all
    /// (by more than 1e-15 anywhere in the layer).
    Eigen::Index n_thin_modes(double length) const;

    /// Throws UserError, beginning with `name`, for E <= 0, nu outside (-1, 0.5) or thickness <= 0.
    void check(const std::string &name) const;
  };

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

  /// In a half-plane, at the scaled depth v = lambda d: yy = -(1+v)e^-v, xx = -(1-v)e^-v, xy = v e^-v.
  WaveStress half_plane_wave(double scaled_depth);

  /**
   * In a layer, u = lambda H, at the height y = (v/u) H above the frictionless face. From the Airy function
   * (a cosh v + b v sinh v) cos(lambda x) with sigma_xy = 0 on both faces (Timoshenko & Goodier, Theory of
   * Elasticity, art. 24), written with decaying exponentials only.
   */
  WaveStress layer_wave(double u, double v);
} // namespace abut
