// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace abut
{
  /// One part of a shrink fit: elastic, between the fit radius and its free radius.
  struct ShrinkFitPart
  {
    double young_modulus;
    double poisson_ratio;
    double free_radius; ///< inner part: below the fit radius, 0 for a solid disc; outer part: above it
  };

  /// A disc or ring inside a ring; lengths in one unit.
  struct ShrinkFitData
  {
    ShrinkFitPart inner;
    ShrinkFitPart outer;
    double radius;       ///< R, where the parts meet
    double interference; ///< D >= 0: how much the inner part is too large, measured on the radius
    double penalty =
        0.; ///< theta: the penetration that remains is theta times the pressure; 0: exact contact
  };

  /// Stress in polar coordinates: force per area, tension positive; the shear vanishes.
  struct PolarStress
  {
    double radial;
    double hoop;
    double axial; ///< nu (radial + hoop): plane strain
  };

  /**
   * Shrink fit of two concentric parts, frictionless, plane strain (Lame; [Timoshenko1970,
   * art. 28]). In each part
   *   sigma_r = A - B/r^2,  sigma_hoop = A + B/r^2,  u_r = (1+nu)/E ((1-2nu) A r + B/r),
   * with sigma_r = -p at r = R and 0 at the free radius. The parts meet when u_o(R) - u_i(R) + theta p = D,
   * hence p = D/(compliance + theta) with
   *
   *   compliance = R [ (1+nu_o)/E_o (R_o^2 + (1-2nu_o)R^2)/(R_o^2 - R^2)
   *
   *                  + (1+nu_i)/E_i (R_i^2 + (1-2nu_i)R^2)/(R^2 - R_i^2) ].
   *
   * The pressure p >= 0 and the stresses are forces per area.
   */
  class ShrinkFit
  {
  public:
    enum class Part
    {
      inner,
      outer
    };

    /// Throws UserError for data that make no sense.
    explicit ShrinkFit(const ShrinkFitData &data);

    /// Growth of the gap at R per unit pressure: length per (force per area).
    double compliance() const { return compliance_; }
    double pressure() const { return pressure_; }
    /// Outward displacement at the distance r from the centre.
    double radial_displacement(Part part, double r) const;
    PolarStress stress(Part part, double r) const;

  private:
    /// A and B of the stresses above.
    struct Field
    {
      double uniform;
      double decaying;
    };

    const ShrinkFitPart &part_data(Part part) const;
    Field field_under_unit_pressure(Part part) const;
    double displacement_under_unit_pressure(Part part, double r) const;

    ShrinkFitData data_;
    double compliance_;
    double pressure_;
  };
} // namespace abut
