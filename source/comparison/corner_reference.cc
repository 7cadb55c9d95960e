// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/corner_reference.h>
#include <abut/comparison/scene_checks.h>

namespace abut
{
  namespace
  {
    ReentrantCorner make_corner(const Scene &scene)
    {
      const SceneChecks checks(scene.reference);
      checks.require_single_body(scene, "L-shape");
      const BodyDescription &body = scene.bodies.front();
      for (const std::string side : {"left", "right", "bottom", "top"})
        checks.require_exact(body, side);
      checks.require_no_further_conditions(body, 4);
      return {body.young_modulus, body.poisson_ratio, scene.reference.amplitude};
    }
  } // namespace

  CornerReference::CornerReference(const Scene &scene) : solution_(make_corner(scene)) {}

  OwnStress CornerReference::stress(std::size_t /*body*/) const
  {
    return [this](const Vector2 &point) { return to_stress(solution_.stress(point)); };
  }

  std::function<Vector2(const Vector2 &)> CornerReference::displacement(std::size_t /*body*/) const
  {
    return [this](const Vector2 &point) { return solution_.displacement(point); };
  }
} // namespace abut
