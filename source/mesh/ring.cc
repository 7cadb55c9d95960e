// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/circle.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    /// Uniform in the angle and in the radius.
    RawMesh quarter_ring(const BodyDescription &body)
    {
      const unsigned int n_arc = body.cells[0], n_radial = body.cells[1];
      const double inner = body.size.at(0), outer = body.size.at(1);

      RawMesh mesh;
      for (unsigned int k = 0; k <= n_arc; ++k)
        for (unsigned int r = 0; r <= n_radial; ++r)
        {
          const double t = double(r) / n_radial;
          mesh.vertices.push_back(((1. - t) * inner + t * outer) * quarter_circle(k, n_arc));
        }

      const auto index = [&](unsigned int r, unsigned int k) { return k * (n_radial + 1) + r; };
      mesh.add_block({{n_radial, n_arc}}, index);
      mesh.add_side("inner", n_arc, [&](unsigned int k) { return index(0, k); });
      mesh.add_side("outer", n_arc, [&](unsigned int k) { return index(n_radial, k); });
      mesh.add_side("left", n_radial, [&](unsigned int r) { return index(r, n_arc); });
      mesh.add_side("bottom", n_radial, [&](unsigned int r) { return index(r, 0); });
      return mesh;
    }

    RawMesh ring(const BodyDescription &body)
    {
      return reflect(reflect(quarter_ring(body), 0, "left"), 1, "bottom");
    }

    /// Two across, as long at the inner arc as across.
    std::array<unsigned int, 2> coarse_cells_of_ring(const std::vector<double> &size)
    {
      constexpr double least = 2., most = 64.;
      const double along = 2. * M_PI / 2. * size.at(0) / (size.at(1) - size.at(0));
      return {{static_cast<unsigned int>(std::lround(std::clamp(along, least, most))), 2}};
    }

    ShapeEntry ring_entry(const std::string &name, const std::string &documentation,
                          RawMesh (*make)(const BodyDescription &))
    {
      ShapeEntry entry{name, documentation};
      entry.size = "inner radius, outer radius";
      entry.order = "the inner below the outer";
      entry.has_curves = true;
      entry.make = make;
      entry.coarse_cells = coarse_cells_of_ring;
      entry.attach_curves = attach_polar_coordinates;
      entry.contact_depth = [](const BodyDescription &body) { return body.size.at(1) - body.size.at(0); };
      return entry;
    }

    const Registered<ShapeEntry> registered_ring(ring_entry(
        "ring",
        "centre at the origin, sides inner, outer; Cells along a quarter of the arc, along the radius",
        ring));
    const Registered<ShapeEntry> registered_quarter_ring(
        ring_entry("quarter ring", "x, y >= 0 of a ring, sides inner, outer, left, bottom; Cells as there",
                   quarter_ring));
  } // namespace
} // namespace abut
