// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/comparison/corner_reference.h>
#include <abut/comparison/scene_checks.h>
#include <abut/scene/reference_entry.h>

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
      return {body.young_modulus, body.poisson_ratio, scene.reference.datum("Amplitude")};
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

  namespace
  {
    ReferenceEntry corner_entry()
    {
      ReferenceEntry entry{"corner", "the singular field of an L-shape"};
      entry.data = {{"Amplitude", "K of the stress K r^(alpha - 1) across the bisector, alpha = 0.54448",
                     "Force / area length^(alpha - 1)"}};
      entry.make = [](const Scene &scene) -> std::unique_ptr<ExactSolution> {
        return std::make_unique<CornerReference>(scene);
      };
      return entry;
    }

    const Registered<ReferenceEntry> registered_corner(corner_entry());
  } // namespace
} // namespace abut
