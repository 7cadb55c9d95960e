// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/prescribed.h>

namespace abut
{
  /// u(x) = translation + rotation (x - centre)^perp / size: a rigid motion, small.
  struct RigidMode
  {
    Vector2 translation;
    double rotation;
    Vector2 centre;
    double size;

    Vector2 displacement(const Vector2 &place) const
    {
      const Vector2 arm = (place - centre) / size;
      return translation + rotation * Vector2(-arm.y(), arm.x());
    }
    /// "translation along (1, 0)", "rotation about (0, 2)"
    std::string description() const;
  };

  /**
   * The rigid motions that the components leave free; empty for a supported body. Decided by the rank of the
   * components on the three rigid modes: a Cholesky factorisation does not notice a singular matrix.
   */
  std::vector<RigidMode> free_rigid_modes(const std::vector<PrescribedComponent> &components,
                                          const Vector2 &centre, double size);
} // namespace abut
