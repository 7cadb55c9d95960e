// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_content.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  std::string to_string(const GmshContent::Side &side)
  {
    return std::to_string(side.id) + (side.name.empty() ? "" : " (" + side.name + ")");
  }

  namespace
  {
    void check_plane(const GmshContent &content, const std::string &where)
    {
      double size = 0.;
      for (const auto &cell : content.cells)
        for (const auto &nodes : {cell.corners, cell.between})
          for (const std::size_t node : nodes)
          {
            const auto &p = content.nodes.at(node);
            size = std::max({size, std::abs(p[0]), std::abs(p[1])});
          }
      for (const auto &cell : content.cells)
        for (const std::size_t node : cell.corners)
        {
          const auto &p = content.nodes.at(node);
          if (std::abs(p[2]) > 1e-10 * size)
          {
            std::ostringstream message;
            message << where << ": it leaves the plane z = 0 at (" << p[0] << ", " << p[1] << ", " << p[2]
                    << ")";
            throw UserError(message.str());
          }
        }
    }

    void check_sides(const GmshContent &content, const std::string &where)
    {
      for (const auto &[curve, sides] : content.sides)
        if (sides.size() > 1)
          throw UserError(where + ": its curve " + std::to_string(curve) + " belongs to the physical lines " +
                          to_string(sides[0]) + " and " + to_string(sides[1]) +
                          ", allowed is one (in files of version 2 lines of the same elementary number are "
                          "one curve)");
    }
  } // namespace

  void check_gmsh_content(const GmshContent &content, const BodyDescription &body, const std::string &where)
  {
    if (content.has_solids)
      throw UserError(where + ": it holds a solid, a body is a plane surface; give the section alone");
    if (body.mesh_size.is_given() && !content.is_geometry)
      throw UserError(where + ": Mesh size is given, but the file is a mesh already; allowed is 0");
    if (content.is_geometry && body.corner_angle != BodyDescription().corner_angle)
      throw UserError(where + ": Corner angle is given, but the curves of a geometry tell where corners are; "
                              "leave it out");
    if (content.cells.empty())
      throw UserError(where + ": it holds no triangles and no quadrilaterals");
    if (content.highest_order > 2)
      throw UserError(where + ": its cells are of order " + std::to_string(content.highest_order) +
                      ", allowed are 1 and 2");
    check_plane(content, where);
    check_sides(content, where);
  }
} // namespace abut
