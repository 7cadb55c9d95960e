// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/comparison/exact_solution.h>
#include <abut/reference/reentrant_corner.h>

namespace abut
{
  /**
   * ReentrantCorner on an L-shape (`corner`): one body, free at its side `corner`, `displacement: exact` on
   * all others; the corner is the origin of its own frame.
   */
  class CornerReference : public ExactSolution
  {
  public:
    /// Throws UserError when the scene is not that of the corner.
    explicit CornerReference(const Scene &scene);

    OwnStress stress(std::size_t body) const override;
    std::function<Vector2(const Vector2 &)> displacement(std::size_t body) const override;
    /// There is no contact whose pressure could be in error.
    OwnStress response(std::size_t body, const BodyResult & /*result*/) const override
    {
      return stress(body);
    }

  private:
    ReentrantCorner solution_;
  };
} // namespace abut
