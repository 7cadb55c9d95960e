// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace abut::testing
{
  using GmshOptions = std::vector<std::pair<std::string, double>>;

  /// What the Gmsh library makes of a geometry file under these options: a mesh, or, where the name asks for
  /// .step, the geometry itself. A new file of the test's own; returns its path.
  std::string written_by_gmsh(const std::string &geometry, const std::string &name,
                              const GmshOptions &options = {});
} // namespace abut::testing
