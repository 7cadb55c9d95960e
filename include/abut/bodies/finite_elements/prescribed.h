// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>
#include <abut/bodies/finite_elements/supports.h>
#include <abut/bodies/reactions.h>

#include <map>
#include <optional>

namespace abut
{
  /// The sides of a body that conditions or contacts name.
  using Sides = std::map<std::string, Trace>;

  /// Translates the displacement conditions of a body into components at its nodes. Throws UserError.
  std::vector<PrescribedComponent> prescribed_components(const BodyDescription &body, const Sides &sides,
                                                         const Space &space);

  /// The directions, with outward unit normal n, along which a condition prescribes the displacement: none
  /// for a load.
  std::vector<Vector2> supported_directions(const Condition &condition, const Placement &placement,
                                            const Vector2 &normal, const std::optional<Resultant> &resultant);

  /// The resultant condition of the body, if it has one. Throws UserError for a side without one direction.
  std::optional<Resultant> find_resultant(const BodyDescription &body, const Sides &sides);

  /// The two unknowns and the place of every node of the space.
  struct Nodes
  {
    std::vector<std::array<unsigned int, 2>> dofs;
    std::vector<Vector2> places;
  };
  Nodes all_nodes(const Space &space);
  /// Those that are free to move: all but the hanging ones.
  Nodes free_nodes(const Space &space);
} // namespace abut
