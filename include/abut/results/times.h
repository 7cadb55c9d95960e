// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/boundary_elements/boundary_cost.h>

namespace abut
{
  /// Wall-clock seconds by task; no second belongs to two of them, but for `bem`.
  struct Times
  {
    double mesh = 0., assemble = 0., factorise = 0., solve = 0., interface = 0., estimate = 0., adapt = 0.,
           output = 0.;
    double bem = 0.;       ///< boundary elements, added up over bodies that are computed side by side
    double reference = 0.; ///< comparing with the exact solution

    Times &operator+=(const Times &other);

    void serialize(Archive &archive)
    {
      archive(mesh, assemble, factorise, solve, interface, estimate, adapt, output, bem, reference);
    }
  };

  /// Seconds that a pass took, and what boundary elements cost; all bodies.
  struct PassCost
  {
    double assemble = 0., factorise = 0., solve = 0.; ///< of the finite elements
    double estimate = 0.;                             ///< boundary elements included
    BoundaryCost boundary;

    void serialize(Archive &archive) { archive(assemble, factorise, solve, estimate, boundary); }
  };
} // namespace abut
