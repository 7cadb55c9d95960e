// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/comparison/corner_reference.h>
#include <abut/comparison/exact_solution.h>
#include <abut/comparison/flat_punch_reference.h>
#include <abut/comparison/hertz_reference.h>
#include <abut/comparison/lame_reference.h>
#include <abut/comparison/layers_reference.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  std::unique_ptr<ExactSolution> make_exact_solution(const Scene &scene)
  {
    switch (scene.reference.solution)
    {
    case ReferenceParameters::Solution::none:
      break;
    case ReferenceParameters::Solution::layers_sliding:
    case ReferenceParameters::Solution::layers_bonded:
    case ReferenceParameters::Solution::infinite_layers_sliding:
    case ReferenceParameters::Solution::infinite_layers_bonded:
      return std::make_unique<LayersReference>(scene);
    case ReferenceParameters::Solution::hertz:
      return std::make_unique<HertzReference>(scene);
    case ReferenceParameters::Solution::lame:
      return std::make_unique<LameReference>(scene);
    case ReferenceParameters::Solution::flat_punch:
      return std::make_unique<FlatPunchReference>(scene);
    case ReferenceParameters::Solution::corner:
      return std::make_unique<CornerReference>(scene);
    }
    return {};
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
