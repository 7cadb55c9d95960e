// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace abut
{
  enum class ConditionKind
  {
    displacement,            ///< two expressions: u, own frame
    displacement_x,          ///< one: u . e_x of the own frame
    displacement_y,          ///< one: u . e_y of the own frame
    normal_displacement,     ///< one: u . n, n outward (0: a roller)
    tangential_displacement, ///< one: u . tau, tau = n turned by +90 degrees (counter-clockwise around the
                             ///< body)
    traction,                ///< two: force per area, own frame
    pressure,                ///< one: traction -p n, positive presses
    resultant ///< two: a force vector (own frame) carried by a rigid side that moves along it; one: along the
              ///< outward normal
  };

  /**
   * What holds on one part of a body's boundary. Lengths (displacements) are those of the own frame, before
   * `Scale`; tractions, pressures and resultants are not scaled.
   */
  struct Condition
  {
    std::string boundary;         ///< name or physical id; for a point its text, e.g. "(0, 1)"
    std::optional<Vector2> point; ///< own-frame place where the condition holds at a single point
    ConditionKind kind;
    std::vector<Expression> expressions; ///< as many as the kind needs
    bool exact = false; ///< the values are those of the exact solution that the scene names; no expressions
  };

  /**
   * Reads `id: kind: expressions; id: kind: ...`: conditions separated by `;`, split at their first two `:`,
   * expressions by commas outside parentheses. Displacements, displacements x and y may be `exact`. `where`
   * begins every message. Throws UserError: a kind that does not exist or that a point cannot take, a wrong
   * number of expressions, a resultant that depends on x or y, the same kind twice on one boundary. Whether
   * the boundary exists is for the mesh to say.
   */
  std::vector<Condition> parse_conditions(const std::string &text, const Constants &constants,
                                          const std::string &where);

  /// Whether the values differ from place to place.
  bool varies(const Condition &condition);

  /// The name used in the parameter file.
  std::string to_string(ConditionKind kind);

  /// Whether the kind prescribes a displacement component (a resultant does too: its amount is unknown).
  bool is_support(ConditionKind kind);
} // namespace abut
