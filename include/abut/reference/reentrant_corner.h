// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>
#include <abut/reference/exact_stress.h>

namespace abut
{
  /**
   * Singular field at the corner of three quadrants, plane strain: material everywhere but in x > 0, y < 0,
   * the faces y = 0, x > 0 and x = 0, y < 0 free of traction, symmetric about the bisector of the material,
   * the direction of the angle 3 pi/4 [Williams1952]. With omega = 3 pi/2 the
   * exponent is the least positive root of
   *   sin(alpha omega) + alpha sin(omega) = 0,   alpha = 0.5444837367...,
   * and in coordinates turned by 3 pi/4, z = r exp(i phi), with |phi| <= omega/2,
   *   2 mu (u + i v) = kappa f - z conj(f') - conj(g),   f = c z^alpha,   g = -c cos(alpha omega) z^alpha,
   *   sigma_xx + sigma_yy = 4 Re f',   sigma_yy - sigma_xx + 2i sigma_xy = 2 (conj(z) f'' + g').
   *
   * Frame: y up, the corner in the origin. Stress in force per area, tension positive, of the degree alpha -
   * 1 in r and infinite at the corner; the displacement is of the degree alpha and zero at the corner.
   */
  class ReentrantCorner
  {
  public:
    /**
     * `amplitude` is K in the stress K r^(alpha-1) across the bisector (sigma_phi phi at phi = 0), of either
     * sign. Throws UserError for data that make no sense.
     */
    ReentrantCorner(double young_modulus, double poisson_ratio, double amplitude);

    double exponent() const { return exponent_; }
    /// At a point of the material other than the corner.
    ExactStress stress(const Vector2 &point) const;
    /// At a point of the material.
    Vector2 displacement(const Vector2 &point) const;

  private:
    double young_modulus_;
    double poisson_ratio_;
    double exponent_;
    double first_;  // c, the factor of f
    double second_; // the factor of g
  };
} // namespace abut
