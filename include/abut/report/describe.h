// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/simulation.h>

#include <iosfwd>

namespace abut
{
  /// What will be solved: bodies, unknowns, supports, rigid motions left free, gaps, penalties.
  void describe(const Simulation &simulation, std::ostream &out);

  /// What a scene with a tolerance begins with: a line on the goal and one for every body.
  void describe_choices(const Simulation &simulation, std::ostream &out);
} // namespace abut
