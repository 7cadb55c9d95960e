// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/gmsh_content.h>
#include <abut/mesh/raw_mesh.h>

namespace abut
{
  struct ConvertedMesh
  {
    RawMesh mesh; ///< with the curves of a geometry
    /// The second-order nodes of the edges of its boundary; empty where none leaves its chord.
    std::vector<std::vector<Vector2>> between;
  };

  /// Cells, sides and materials of what a file holds. Throws UserError, beginning with `where`: bad cells,
  /// several parts, names and regions that mean nothing or several things.
  ConvertedMesh convert(const GmshContent &content, const BodyDescription &body, const std::string &where);
} // namespace abut
