// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /**
   * How a body's own frame lies in the plane: x = shift + R(angle) M s X, with the scale s, the mirror image
   * M (X -> -X in the first component, where asked for) and the rotation R, counter-clockwise in degrees.
   * Lengths of the own frame are multiplied by s; directions turn and are mirrored but keep their length.
   * Multiples of 90 degrees are exact.
   */
  class Placement
  {
  public:
    Placement() = default;
    /// Requires scale > 0.
    Placement(double scale, bool mirrored, double angle_in_degrees, const Vector2 &shift);

    Vector2 point_to_world(const Vector2 &own_point) const;
    Vector2 point_to_own(const Vector2 &world_point) const;
    Vector2 direction_to_world(const Vector2 &own_direction) const;
    double length_to_world(double own_length) const { return scale_ * own_length; }
    bool is_mirrored() const { return mirrored_; }

  private:
    double scale_ = 1.;
    bool mirrored_ = false;
    Eigen::Matrix2d turn_ = Eigen::Matrix2d::Identity(); // R M
    Vector2 shift_ = Vector2::Zero();
  };

  /// The entries of a placement.
  void declare_placement(dealii::ParameterHandler &prm);
  /// Throws UserError, beginning with `where`.
  Placement parse_placement(const dealii::ParameterHandler &prm, const std::string &where);
} // namespace abut
