// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/comparison/exact_solution.h>
#include <abut/scene/reference_entry.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    const Registered<ReferenceEntry> registered_no_reference({"none", "nothing to compare with"});
  } // namespace

  std::unique_ptr<ExactSolution> make_exact_solution(const Scene &scene)
  {
    const ReferenceEntry &entry = Registry<ReferenceEntry>::get().find(scene.reference.solution);
    return entry.make != nullptr ? entry.make(scene) : nullptr;
  }

  BodyDescription with_exact_conditions(const Scene &scene, const std::size_t body,
                                        const ExactSolution *const exact)
  {
    AssertIndexRange(body, scene.bodies.size());
    BodyDescription description = scene.bodies[body];
    for (Condition &condition : description.conditions)
    {
      if (!condition.exact)
        continue;
      Assert(exact != nullptr,
             dealii::ExcMessage("`exact` needs a solution; scenes without one are refused"));
      const std::string where = "Body " + description.name + "/Conditions: " + condition.boundary;
      const auto displacement = exact->displacement(body);
      if (!displacement)
        throw UserError(where +
                        ": received `exact`, but the solution that Reference/Exact solution names does "
                        "not tell displacements");
      const auto add = [&](const int component) {
        condition.expressions.emplace_back(
            [displacement, component](const Vector2 &point) { return displacement(point)[component]; },
            "exact(x, y)", where);
      };
      if (condition.kind != ConditionKind::displacement_y)
        add(0);
      if (condition.kind != ConditionKind::displacement_x)
        add(1);
    }
    return description;
  }
} // namespace abut
