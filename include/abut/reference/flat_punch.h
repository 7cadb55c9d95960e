// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/reference/exact_stress.h>

namespace abut
{
  /// A punch and the half-plane under it.
  struct FlatPunchData
  {
    double young_modulus;
    double poisson_ratio;
    double half_width; ///< a > 0: the punch covers |x| < a
    double force;      ///< P > 0 per unit thickness of the plane, presses down
  };

  /**
   * Rigid frictionless punch with a flat base on the elastic half-plane y <= 0, plane strain
   * [Johnson1985, sec. 2.8]. With z = x + i d, d = -y the depth, p(x) = P/(pi sqrt(a^2 - x^2)),
   * G(z) = i P/(pi sqrt(z^2 - a^2)),   p = Re G on the surface, sigma_yy = -(Re G + d Im G'),  sigma_xx =
   * -(Re G - d Im G'),  sigma_xy = -d Re G', 2 mu u_x = -(1 - 2nu) Re F + d Im G,   2 mu u_y = 2(1 - nu) Im F
   * - d Re G,   F' = G, with F = i (P/pi) ln((z + sqrt(z^2 - a^2))/a) and a constant that makes u_x odd. The
   * displacement is measured from the punch: u_y = 0 under it, and grows like a logarithm far away.
   *
   * Frame: y up, the middle of the punch at x = 0. Stress in force per area, tension positive; p > 0 presses.
   * At the edges (+-a, 0) the stress is infinite and what is returned not finite.
   */
  class FlatPunch
  {
  public:
    /// Throws UserError for data that make no sense.
    explicit FlatPunch(const FlatPunchData &data);

    /// At the distance x from the middle; zero beyond the edge, infinite at it.
    double pressure(double x) const;
    /// At a point with y <= 0.
    ExactStress stress(const Vector2 &point) const;
    /// At a point with y <= 0.
    Vector2 displacement(const Vector2 &point) const;

  private:
    FlatPunchData data_;
  };
} // namespace abut
