// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/shapes.h>

namespace abut
{
  RawMesh ring(const BodyDescription &body)
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
    return body.shape == Shape::quarter_ring ? mesh : reflect(reflect(mesh, 0, "left"), 1, "bottom");
  }
} // namespace abut
