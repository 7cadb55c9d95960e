// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/finite_elements/space.h>

namespace abut
{
  /**
   * The pairs of sides that a body's description glues, each with its slave. Where both sides cover each
   * other and none is named, the slave is the softer one, of equally soft ones the finer (or as Mortar/Slave
   * says). Throws UserError: sides that do not lie on each other, or in part only, that have fewer than two
   * nodes between corners, conditions on glued sides, pieces of the mesh that nothing joins.
   */
  std::vector<GluedSides> find_glue(const Space &space, const BodyDescription &body,
                                    const std::vector<std::string> &contact_sides);
} // namespace abut
