// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/vector2.h>

#include <map>
#include <string>

namespace abut
{
  /// Forces of the supports on the body, and how well the body is in balance.
  struct Reactions
  {
    std::map<std::string, Vector2> by_boundary;
    Vector2 applied = Vector2::Zero(); ///< resultant of tractions and body force
    Vector2 contact = Vector2::Zero(); ///< resultant of the contact forces
    double equilibrium_residual = 0.;  ///< |sum of all forces| / sum of their sizes
    /// |sum of all moments| / (diagonal of the bounding box times the sum of the forces' sizes). Round-off
    /// but where hanging nodes meet curved edges: there a rotation is no field of the finite elements.
    double moment_residual = 0.;

    void serialize(Archive &archive)
    {
      archive(by_boundary, applied, contact, equilibrium_residual, moment_residual);
    }
  };

  /// A rigid side that carries a given force: the displacement delta along `direction` is to be found.
  struct Resultant
  {
    std::string boundary;
    Vector2 direction; ///< unit, world frame
    double force;      ///< the component of the support's force on the body along `direction`

    void serialize(Archive &archive) { archive(boundary, direction, force); }
  };

  /// The largest part of the loads on a side that its supports take at once, and the largest load: force per
  /// area.
  struct LostLoad
  {
    double lost = 0., largest = 0.;

    void serialize(Archive &archive) { archive(lost, largest); }
  };
} // namespace abut
