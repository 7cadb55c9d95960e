// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/flat_punch.h>

namespace abut
{
  /**
   * FlatPunch on the right half of a half-plane (`flat punch`), cut out as a rectangle: its top, y = Size 2
   * of its own frame, is the surface and x = 0 the middle. `left` is a roller, `top` carries the punch's
   * pressure as a formula, `displacement: exact` holds on the other two sides.
   */
  class FlatPunchReference : public ExactSolution
  {
  public:
    /// Throws UserError when the scene is not that of the punch.
    explicit FlatPunchReference(const Scene &scene);

    OwnStress stress(std::size_t body) const override;
    std::function<Vector2(const Vector2 &)> displacement(std::size_t body) const override;
    /// The pressure is given, not found: only its quadrature is in error.
    OwnStress response(std::size_t body, const BodyResult & /*result*/) const override
    {
      return stress(body);
    }

  private:
    Vector2 surface_origin_; ///< own frame
    FlatPunch solution_;
  };
} // namespace abut
