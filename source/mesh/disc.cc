// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/circle.h>
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

namespace abut
{
  namespace
  {
    // Corners of the core, in radii: (0, 0), (side, 0), (corner, corner), (0, side). Pulling the corner in
    // makes room for the cells between it and the arc.
    constexpr double core_side = 0.5;
    constexpr double core_corner = 0.4;

    Vector2 core_point(const double s, const double t)
    {
      return Vector2(s * ((1. - t) * core_side + t * core_corner),
                     t * ((1. - s) * core_side + s * core_corner));
    }

    /// Numbers of the vertices of a quarter disc: those of the core, then arc after arc outwards.
    struct QuarterDiscNumbering
    {
      unsigned int n_arc, n_radial;

      unsigned int half() const { return n_arc / 2; }
      unsigned int core(unsigned int i, unsigned int j) const { return j * (half() + 1) + i; }

      /// The k-th vertex (from the x axis) of the r-th arc; arc 0 is the rim of the core.
      unsigned int arc(unsigned int r, unsigned int k) const
      {
        if (r > 0)
          return (half() + 1) * (half() + 1) + (r - 1) * (n_arc + 1) + k;
        return k <= half() ? core(half(), k) : core(n_arc - k, half());
      }
    };

    /// A square core of n/2 x n/2 cells (n along the arc, even) and around it n x m cells up to the arc.
    RawMesh quarter_disc_mesh(const double radius, const QuarterDiscNumbering &number)
    {
      const auto [n, m] = number;
      const unsigned int half = number.half();
      RawMesh mesh;
      for (unsigned int j = 0; j <= half; ++j)
        for (unsigned int i = 0; i <= half; ++i)
          mesh.vertices.push_back(radius * core_point(double(i) / half, double(j) / half));
      for (unsigned int r = 1; r <= m; ++r)
        for (unsigned int k = 0; k <= n; ++k)
        {
          const double t = double(r) / m;
          const Vector2 start = mesh.vertices[number.arc(0, k)];
          const Vector2 end = radius * quarter_circle(k, n);
          mesh.vertices.push_back((1. - t) * start + t * end);
        }

      mesh.add_block({{half, half}}, [&](unsigned int i, unsigned int j) { return number.core(i, j); });
      mesh.add_block({{m, n}}, [&](unsigned int r, unsigned int k) { return number.arc(r, k); });

      mesh.add_side("outer", n, [&](unsigned int k) { return number.arc(number.n_radial, k); });
      mesh.add_side("left", half, [&](unsigned int j) { return number.core(0, j); });
      mesh.add_side("left", m, [&](unsigned int r) { return number.arc(r, number.n_arc); });
      mesh.add_side("bottom", half, [&](unsigned int i) { return number.core(i, 0); });
      mesh.add_side("bottom", m, [&](unsigned int r) { return number.arc(r, 0); });
      return mesh;
    }

    RawMesh quarter_disc(const BodyDescription &body)
    {
      if (body.cells[0] % 2 != 0)
        throw UserError(body.section() + "/Cells: " + std::to_string(body.cells[0]) +
                        " cells along a quarter arc; a disc needs an even number");
      return quarter_disc_mesh(body.size.at(0), {body.cells[0], body.cells[1]});
    }

    RawMesh half_disc(const BodyDescription &body)
    {
      return reflect(quarter_disc(body), 0, "left");
    }

    RawMesh disc(const BodyDescription &body)
    {
      return reflect(half_disc(body), 1, "bottom");
    }

    ShapeEntry disc_entry(const std::string &name, const std::string &documentation,
                          RawMesh (*make)(const BodyDescription &))
    {
      ShapeEntry entry{name, documentation};
      entry.size = "radius";
      entry.has_curves = true;
      entry.make = make;
      entry.coarse_cells = [](const std::vector<double> &) { return std::array<unsigned int, 2>{{4, 2}}; };
      entry.attach_curves = attach_outer_circle;
      entry.contact_depth = [](const BodyDescription &body) { return body.size.at(0); };
      return entry;
    }

    const Registered<ShapeEntry>
        registered_disc(disc_entry("disc",
                                   "centre at the origin, side outer; Cells along a quarter of the arc (an "
                                   "even number), along the radius",
                                   disc));
    const Registered<ShapeEntry> registered_half_disc(
        disc_entry("half disc", "y >= 0 of a disc, sides outer, bottom; Cells as there", half_disc));
    const Registered<ShapeEntry> registered_quarter_disc(disc_entry(
        "quarter disc", "x, y >= 0 of a disc, sides outer, left, bottom; Cells as there", quarter_disc));
  } // namespace
} // namespace abut
