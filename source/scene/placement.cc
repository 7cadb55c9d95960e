// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/scene/placement.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace abut
{
  namespace
  {
    /// Counter-clockwise rotation; a multiple of 90 degrees has entries 0 and +-1 exactly.
    Eigen::Matrix2d rotation(const double angle_in_degrees)
    {
      const double angle = std::remainder(angle_in_degrees, 360.);
      const int quarter_turns = static_cast<int>(std::lround(angle / 90.));
      const double rest = (angle - 90. * quarter_turns) * (std::acos(-1.) / 180.);

      Eigen::Matrix2d result, quarter;
      result << std::cos(rest), -std::sin(rest), std::sin(rest), std::cos(rest);
      quarter << 0., -1., 1., 0.;
      for (int turn = 0; turn < (quarter_turns + 4) % 4; ++turn)
        result = (quarter * result).eval();
      return result;
    }
  } // namespace

  Placement::Placement(const double scale, const bool mirrored, const double angle_in_degrees,
                       const Vector2 &shift)
      : scale_(scale), mirrored_(mirrored), turn_(rotation(angle_in_degrees)), shift_(shift)
  {
    Assert(scale > 0. && std::isfinite(scale), dealii::ExcMessage("a scale is a number above 0"));
    Assert(shift.allFinite() && turn_.allFinite(), dealii::ExcMessage("a placement is finite"));
    if (mirrored)
      turn_.col(0) *= -1.;
  }

  Vector2 Placement::point_to_world(const Vector2 &own_point) const
  {
    return shift_ + turn_ * (scale_ * own_point);
  }

  Vector2 Placement::point_to_own(const Vector2 &world_point) const
  {
    return turn_.transpose() * (world_point - shift_) / scale_;
  }

  Vector2 Placement::direction_to_world(const Vector2 &own_direction) const
  {
    return turn_ * own_direction;
  }
} // namespace abut
