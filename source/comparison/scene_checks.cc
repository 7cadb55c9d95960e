// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/comparison/scene_checks.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  bool agree(const double a, const double b)
  {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
  }

  const Condition *find_condition(const BodyDescription &body, const std::string &boundary,
                                  const ConditionKind kind)
  {
    for (const Condition &condition : body.conditions)
      if (condition.boundary == boundary && condition.kind == kind)
        return &condition;
    return nullptr;
  }

  void SceneChecks::require(const bool holds, const std::string &what) const
  {
    if (!holds)
      throw UserError("Reference/Exact solution: received `" + solution_ +
                      "`, which is not this scene's: " + what);
  }

  double SceneChecks::constant(const BodyDescription &body, const Condition &condition,
                               const std::size_t component) const
  {
    require(!condition.exact && condition.expressions.at(component).is_constant(),
            "`" + to_string(condition.kind) + "` of " + body.name + ":" + condition.boundary +
                " must be a constant");
    return condition.expressions[component](Vector2::Zero());
  }

  void SceneChecks::require_roller(const BodyDescription &body, const std::string &side) const
  {
    const Condition *const roller = find_condition(body, side, ConditionKind::normal_displacement);
    require(roller != nullptr && constant(body, *roller) == 0.,
            body.name + ":" + side + " needs a roller (normal displacement: 0)");
  }

  void SceneChecks::require_exact(const BodyDescription &body, const std::string &side) const
  {
    const Condition *const condition = find_condition(body, side, ConditionKind::displacement);
    require(condition != nullptr && condition->exact,
            body.name + ":" + side + " needs the condition `displacement: exact`");
  }

  void SceneChecks::require_no_body_force(const BodyDescription &body) const
  {
    require(body.body_force.empty(), "body " + body.name + " has a body force, it must have none");
  }

  void SceneChecks::require_single_body(const Scene &scene, const std::string &shape) const
  {
    require(scene.bodies.size() == 1 && scene.contacts.empty(), "it needs one body and no contact");
    const BodyDescription &body = scene.bodies.front();
    require(body.shape == shape, "body " + body.name + " must have the shape `" + shape + "`");
    require_no_body_force(body);
  }

  void SceneChecks::require_pair(const Scene &scene) const
  {
    require(scene.bodies.size() == 2 && scene.contacts.size() == 1 &&
                scene.contacts.front().slave.body != scene.contacts.front().master.body,
            "it needs two bodies and one contact between them");
    for (const BodyDescription &body : scene.bodies)
      require_no_body_force(body);
  }

  void SceneChecks::require_no_further_conditions(const BodyDescription &body, const std::size_t n) const
  {
    require(body.conditions.size() == n, "body " + body.name + " has " +
                                             std::to_string(body.conditions.size()) +
                                             " conditions, it must have " + std::to_string(n));
  }
} // namespace abut
