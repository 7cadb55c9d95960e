// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/scene/scene.h>

#include <functional>
#include <memory>
#include <optional>

namespace abut
{
  struct BodyResult;

  /// A stress at a point of a body's own frame.
  using OwnStress = std::function<Stress(const Vector2 &own_point)>;

  /**
   * The exact solution that a scene names (`Reference/Exact solution`), seen from the scene's bodies: points,
   * lengths and vectors in a body's own frame. Each solution knows some of what follows; what it does not
   * know is empty.
   */
  class ExactSolution
  {
  public:
    virtual ~ExactSolution() = default;

    /// The stress of a body.
    virtual OwnStress stress(std::size_t /*body*/) const { return {}; }
    /// The displacement of a body, before `Scale`.
    virtual std::function<Vector2(const Vector2 &own_point)> displacement(std::size_t /*body*/) const
    {
      return {};
    }
    /// The contact pressure at a point of the slave side.
    virtual std::function<double(const Vector2 &own_point)> pressure() const { return {}; }
    /// The resultant of the contact pressure.
    virtual std::optional<double> force() const { return {}; }
    /// The stress with which a body answers the contact traction that was applied (`applied_traction`), apart
    /// from any error of that traction: sigma* of an estimator's effectivity.
    virtual OwnStress response(std::size_t /*body*/, const BodyResult & /*result*/) const { return {}; }
  };

  /// Checks that the scene is the solution's. Throws UserError; empty where the scene names none.
  std::unique_ptr<ExactSolution> make_exact_solution(const Scene &scene);

  /// The body with its conditions of the kind `exact` filled in. Throws UserError where the solution knows no
  /// displacement. `exact` may be null.
  BodyDescription with_exact_conditions(const Scene &scene, std::size_t body, const ExactSolution *exact);
} // namespace abut
