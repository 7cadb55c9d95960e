// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/vector2.h>

#include <string>

namespace abut
{
  /// What the error that `Tolerance` limits belongs to.
  struct Goal
  {
    enum class Kind
    {
      energy,        ///< the displacement, energy norm, all bodies
      force,         ///< the sum of all contacts' normal forces
      peak_pressure, ///< the largest contact pressure
      stress         ///< von Mises at a point
    };

    Kind kind = Kind::energy;
    Vector2 point = Vector2::Zero(); ///< of the stress, undeformed, world frame

    bool is_energy() const { return kind == Kind::energy; }
    /// In words, as in the parameter file.
    std::string text() const;
    /// Throws UserError.
    static Goal parse(const std::string &text);
  };
} // namespace abut
