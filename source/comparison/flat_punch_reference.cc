// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/flat_punch_reference.h>
#include <abut/comparison/scene_checks.h>
#include <abut/scene/reference_entry.h>

#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    /// The formula of the top against the punch's pressure, at some places under the punch and beside it.
    void check_punch_pressure(const SceneChecks &checks, const BodyDescription &body, const FlatPunch &punch,
                              const double half_width)
    {
      const Condition *const load = find_condition(body, "top", ConditionKind::pressure);
      checks.require(load != nullptr,
                     body.name + ":top needs the condition `pressure` with the punch's formula");
      const double width = body.size[0], height = body.size[1], beside = width - half_width;
      for (const double x : {0., .13 * half_width, .5 * half_width, .77 * half_width, .999 * half_width,
                             half_width + .001 * beside, half_width + .4 * beside, width})
      {
        const double needed = punch.pressure(x), received = load->expressions.front()(Vector2(x, height));
        std::ostringstream text;
        text << "the pressure of " << body.name << ":top is " << received << " at x = " << x
             << ", it must be " << needed << ", P/(pi sqrt(a^2 - x^2)) under the punch and 0 beside it";
        checks.require(std::abs(received - needed) <= 1e-9 * punch.pressure(0.), text.str());
      }
    }

    FlatPunch make_punch(const Scene &scene)
    {
      const SceneChecks checks(scene.reference);
      checks.require_single_body(scene, "rectangle");
      const BodyDescription &body = scene.bodies.front();
      const double half_width = scene.reference.datum("Half width");
      std::ostringstream text;
      text << "Reference/Half width = " << half_width << " must be below the width of body " << body.name
           << ", " << body.size[0];
      checks.require(half_width < body.size[0], text.str());
      checks.require_roller(body, "left");
      for (const std::string side : {"right", "bottom"})
        checks.require_exact(body, side);
      const FlatPunch punch(
          {body.young_modulus, body.poisson_ratio, half_width, scene.reference.datum("Force")});
      check_punch_pressure(checks, body, punch, half_width);
      checks.require_no_further_conditions(body, 4);
      return punch;
    }
  } // namespace

  FlatPunchReference::FlatPunchReference(const Scene &scene)
      : surface_origin_(Vector2::Zero()), solution_(make_punch(scene))
  {
    surface_origin_ = Vector2(0., scene.bodies.front().size[1]);
  }

  OwnStress FlatPunchReference::stress(std::size_t /*body*/) const
  {
    return [this](const Vector2 &point) { return to_stress(solution_.stress(point - surface_origin_)); };
  }

  std::function<Vector2(const Vector2 &)> FlatPunchReference::displacement(std::size_t /*body*/) const
  {
    return [this](const Vector2 &point) { return solution_.displacement(point - surface_origin_); };
  }

  namespace
  {
    ReferenceEntry flat_punch_entry()
    {
      ReferenceEntry entry{"flat punch",
                           "a half-plane, cut out as a rectangle, under the pressure of a rigid punch"};
      entry.data = {{"Force", pressing_force, "Force / thickness"},
                    {"Half width", "a, half of the punch's width", "Length"}};
      entry.make = [](const Scene &scene) -> std::unique_ptr<ExactSolution> {
        return std::make_unique<FlatPunchReference>(scene);
      };
      return entry;
    }

    const Registered<ReferenceEntry> registered_flat_punch(flat_punch_entry());
  } // namespace
} // namespace abut
