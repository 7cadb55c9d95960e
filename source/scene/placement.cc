// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/scene/placement.h>
#include <abut/scene/shape_parameters.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

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

  namespace
  {
    /// The value of an entry whose lower bound is not allowed itself.
    double positive(const dealii::ParameterHandler &prm, const std::string &entry, const std::string &where)
    {
      const double value = prm.get_double(entry);
      if (!(value > 0.))
        throw UserError(where + entry + ": received `" + prm.get(entry) + "`, allowed are numbers above 0");
      return value;
    }
  } // namespace

  void declare_placement(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Scale", "1", dealii::Patterns::Double(0.),
                      "Factor, above 0, on every length of the own frame. No unit.");
    prm.declare_entry("Mirror", "false", dealii::Patterns::Bool(),
                      "Whether the body is mirrored, x to -x, before it is turned.");
    prm.declare_entry("Rotation angle", "0", dealii::Patterns::Double(),
                      "Counter-clockwise, about the origin of the own frame. Degrees.");
    prm.declare_entry("Shift", "0, 0", dealii::Patterns::List(dealii::Patterns::Double(), 2, 2),
                      "Where the origin of the own frame lies in the plane. Length.");
  }

  Placement parse_placement(const dealii::ParameterHandler &prm, const std::string &where)
  {
    const auto shift = numbers_of(prm, "Shift");
    return {positive(prm, "Scale", where),
            prm.get_bool("Mirror"),
            prm.get_double("Rotation angle"),
            {shift[0], shift[1]}};
  }
} // namespace abut
