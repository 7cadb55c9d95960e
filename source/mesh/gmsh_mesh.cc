// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/flat_corners.h>
#include <abut/mesh/gmsh_content.h>
#include <abut/mesh/gmsh_conversion.h>
#include <abut/mesh/gmsh_library.h>
#include <abut/mesh/gmsh_mesh.h>
#include <abut/mesh/mesh_checks.h>
#include <abut/mesh/side_facets.h>
#include <abut/mesh/smooth_sides.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double no_corners = 180.; // degrees: a geometry says itself where its corners are

    /// The curves that the edges stand for, and how they do.
    void add_curves(RawMesh &mesh, const std::vector<std::vector<Vector2>> &between,
                    const BodyDescription &body, const bool is_geometry)
    {
      if (!is_geometry)
        smooth_sides(mesh, between, body.corner_angle * M_PI / 180.);
      mesh.facets = side_facets(mesh, is_geometry ? no_corners : body.corner_angle);
      for (auto &[side, facets] : mesh.facets)
        facets.followed = body.boundary_curve == BoundaryCurve::smooth;
      if (body.boundary_curve == BoundaryCurve::smooth)
        return;
      mesh.inner_edges.clear();
      for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i)
      {
        auto &[ends, side, curve, material] = mesh.boundary_edges[i];
        curve.clear();
        if (!between.empty() && !between[i].empty()) // a parabola, as the cell has it
          curve = {mesh.vertices[ends[0]], between[i].front(), mesh.vertices[ends[1]]};
      }
    }
    RawMesh mesh_of(const GmshContent &content, const BodyDescription &body, const std::string &where)
    {
      check_gmsh_content(content, body, where);
      auto [mesh, between] = convert(content, body, where);
      add_curves(mesh, between, body, content.is_geometry);
      swap_flat_corners(mesh);
      return mesh;
    }

    /// Meshes a geometry; where that has not made the cells that were asked for, or bad ones, once more with
    /// smaller cells.
    RawMesh mesh_of_geometry(const BodyDescription &body, const std::string &where)
    {
      constexpr double smallest = .3, step = .1; // factors of the size
      for (double size_factor = 1.;; size_factor -= step)
      {
        const bool is_last = size_factor - step < smallest;
        mesh_gmsh_geometry(size_factor);
        try
        {
          const RawMesh mesh = mesh_of(read_gmsh_model(true), body, where);
          if (is_last || (mesh.cell_type == body.cell_type && !flat_corner(mesh)))
            return mesh;
        }
        catch (const BadCells &)
        {
          if (is_last)
            throw;
        }
      }
    }

    void check_flat_corners(const RawMesh &mesh, const std::string &where)
    {
      const auto place = flat_corner(mesh);
      if (!place)
        return;
      std::ostringstream message;
      message << where << ": a cell has two edges on a smooth curve, with the corner (" << place->x() << ", "
              << place->y()
              << ") between them, where its angle would be 180 degrees; give the corner an edge "
              << "inside the body (another Mesh size or Cell type), or take Boundary curve = as meshed";
      throw UserError(message.str());
    }
  } // namespace

  RawMesh mesh_by_gmsh(const BodyDescription &body, const std::string &where,
                       const std::function<void()> &make_model)
  {
    const GmshLibrary library;
    RawMesh mesh;
    with_our_words(where, [&]() {
      make_model();
      mesh = prepare_gmsh_geometry(body, where) ? mesh_of_geometry(body, where)
                                                : mesh_of(read_gmsh_model(false), body, where);
    });
    check_flat_corners(mesh, where);
    return mesh;
  }
} // namespace abut
