// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /// A force on a body: per unit of thickness, along the axes of the scene.
  struct ForceOnBody
  {
    std::string body;
    std::string origin; ///< `contact joint`, `support top`
    Vector2 force;
  };

  /// Of every contact on its slave, the master gets the opposite; then of every support on its body;
  /// what is round-off beside the largest component is 0.
  std::vector<ForceOnBody> forces_on_bodies(const Results &results);

  /// A body whose forces or moments do not balance up to round-off.
  struct Imbalance
  {
    std::string body;
    double forces, moments; ///< see Reactions
  };

  std::vector<Imbalance> imbalances(const Results &results);
} // namespace abut
