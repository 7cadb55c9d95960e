// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /**
   * Frictionless line contact of two cylinders in plane strain [Hertz1882], [Johnson1985,
   * sec. 4.2 and app. 3]:
   *   a = sqrt(4 P R/(pi E*)),  p0 = 2P/(pi a),  p(x) = p0 sqrt(1 - x^2/a^2) >= 0.
   * P is the force per unit thickness of the plane, 1/R = 1/R_1 + 1/R_2 (negative for a hollow side, 0 for a
   * flat one) and 1/E* = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2. Bodies are taken as half-planes: the relative error
   * is of the order (a/size)^2.
   */
  class HertzLineContact
  {
  public:
    /// Throws UserError unless all three are positive.
    HertzLineContact(double force, double radius, double modulus);

    double half_width() const { return half_width_; }
    double max_pressure() const { return max_pressure_; }
    /// At the distance x from the middle of the contact; zero outside.
    double pressure(double x) const;

  private:
    double half_width_;
    double max_pressure_;
  };

  /// E* of two bodies.
  double composite_modulus(double young_modulus_1, double poisson_ratio_1, double young_modulus_2,
                           double poisson_ratio_2);
} // namespace abut
