// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/reactions.h>
#include <abut/scene/body_description.h>
#include <abut/trace/trace.h>

#include <functional>
#include <map>
#include <optional>

namespace abut
{
  /**
   * One prescribed displacement component at one node: u . direction = value + per_unit delta, where delta is
   * the displacement of the scene's rigid side that carries a given resultant.
   */
  struct PrescribedComponent
  {
    std::array<unsigned int, 2> dofs;
    Vector2 place;
    Vector2 direction; ///< unit
    double value;
    double per_unit;
    std::string boundary; ///< where the condition was given
  };

  /// The sides of a body that conditions or contacts name.
  using Sides = std::map<std::string, Trace>;

  /// The two unknowns and the place of every node of the space.
  struct Nodes
  {
    std::vector<std::array<unsigned int, 2>> dofs;
    std::vector<Vector2> places;
  };

  /// Translates the displacement conditions of a body into components at its nodes. `nodes`, those that a
  /// point may be, are only asked for where a condition holds at a point. Throws UserError.
  std::vector<PrescribedComponent> prescribed_components(const BodyDescription &body, const Sides &sides,
                                                         const std::function<Nodes()> &nodes);

  /// The directions, with outward unit normal n, along which a condition prescribes the displacement: none
  /// for a load.
  std::vector<Vector2> supported_directions(const Condition &condition, const Placement &placement,
                                            const Vector2 &normal, const std::optional<Resultant> &resultant);

  /// The displacement (world frame) that a condition prescribes at a point of a side, where the outward unit
  /// normal is n: zero along directions that it leaves free.
  Vector2 prescribed_displacement(const Condition &condition, const Placement &placement,
                                  const Vector2 &point, const Vector2 &normal);

  /// The resultant condition of the body, if it has one. Throws UserError for a side without one direction.
  std::optional<Resultant> find_resultant(const BodyDescription &body, const Sides &sides);
} // namespace abut
