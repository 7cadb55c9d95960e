// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/raw_mesh.h>

namespace abut
{
  /// By boundary id, of a mesh whose edges have their curves. `corner_angle` in degrees.
  std::map<unsigned int, SideFacets> side_facets(const RawMesh &mesh, double corner_angle);
} // namespace abut
