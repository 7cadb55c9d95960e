// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

namespace
{
  using namespace abut;

  /// Rows of cells from the bottom to the top, each as wide as the body is there.
  RawMesh right_trapezium(const BodyDescription &body)
  {
    const unsigned int nx = body.cells[0], ny = body.cells[1];
    const double bottom = body.size[0], top = body.size[1], height = body.size[2];
    RawMesh mesh;
    for (unsigned int j = 0; j <= ny; ++j)
      for (unsigned int i = 0; i <= nx; ++i)
      {
        const double t = double(j) / ny;
        mesh.vertices.emplace_back(((1. - t) * bottom + t * top) * i / nx, t * height);
      }

    const auto index = [&](unsigned int i, unsigned int j) { return j * (nx + 1) + i; };
    mesh.add_block({{nx, ny}}, index);
    mesh.add_side("left", ny, [&](unsigned int j) { return index(0, j); });
    mesh.add_side("right", ny, [&](unsigned int j) { return index(nx, j); });
    mesh.add_side("bottom", nx, [&](unsigned int i) { return index(i, 0); });
    mesh.add_side("top", nx, [&](unsigned int i) { return index(i, ny); });
    return mesh;
  }

  ShapeEntry right_trapezium_entry()
  {
    ShapeEntry entry{"right trapezium", "corner at the origin, left side upright, sides left, right, bottom, "
                                        "top; Cells along x, along y"};
    entry.size = "bottom width, top width, height";
    entry.make = right_trapezium;
    entry.coarse_cells = [](const std::vector<double> &) { return std::array<unsigned int, 2>{{2, 2}}; };
    return entry;
  }

  const Registered<ShapeEntry> registered_right_trapezium(right_trapezium_entry());
} // namespace
