// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/raw_mesh.h>
#include <abut/scene/shape_entry.h>

namespace abut
{
  namespace
  {
    /// Numbers of the vertices of the square's lattice that belong to the L.
    class LShapeNumbering
    {
    public:
      explicit LShapeNumbering(const std::array<unsigned int, 2> &n) : n_(n) {}

      /// The lattice runs over 0 ... 2 n along each axis; its corner x > n_x, y < n_y is cut off.
      bool contains(const unsigned int i, const unsigned int j) const { return i <= n_[0] || j >= n_[1]; }

      unsigned int operator()(const unsigned int i, const unsigned int j) const
      {
        const unsigned int narrow = n_[0] + 1, wide = 2 * n_[0] + 1;
        return j < n_[1] ? j * narrow + i : n_[1] * narrow + (j - n_[1]) * wide + i;
      }

    private:
      std::array<unsigned int, 2> n_;
    };

    /// Three squares around the origin, n[0] x n[1] cells each.
    RawMesh l_shape(const BodyDescription &body)
    {
      const unsigned int nx = body.cells[0], ny = body.cells[1];
      const double a = body.size.at(0);
      const LShapeNumbering number(body.cells);
      RawMesh mesh;
      for (unsigned int j = 0; j <= 2 * ny; ++j)
        for (unsigned int i = 0; i <= 2 * nx; ++i)
          if (number.contains(i, j))
            mesh.vertices.emplace_back(a * (double(i) / nx - 1.), a * (double(j) / ny - 1.));

      mesh.add_block({{nx, ny}}, [&](unsigned int i, unsigned int j) { return number(i, j); });
      mesh.add_block({{2 * nx, ny}}, [&](unsigned int i, unsigned int j) { return number(i, ny + j); });

      mesh.add_side("left", 2 * ny, [&](unsigned int j) { return number(0, j); });
      mesh.add_side("right", ny, [&](unsigned int j) { return number(2 * nx, ny + j); });
      mesh.add_side("bottom", nx, [&](unsigned int i) { return number(i, 0); });
      mesh.add_side("top", 2 * nx, [&](unsigned int i) { return number(i, 2 * ny); });
      mesh.add_side("corner", ny, [&](unsigned int j) { return number(nx, j); });
      mesh.add_side("corner", nx, [&](unsigned int i) { return number(nx + i, ny); });
      return mesh;
    }

    ShapeEntry l_shape_entry()
    {
      ShapeEntry entry{"L-shape", "the square of twice the size around the origin without its quarter x > 0, "
                                  "y < 0, sides left, right, bottom, top and corner, the two edges that meet "
                                  "at the origin; Cells along x, along y of each of its three squares"};
      entry.size = "half width";
      entry.make = l_shape;
      entry.coarse_cells = [](const std::vector<double> &) { return std::array<unsigned int, 2>{{2, 2}}; };
      return entry;
    }

    const Registered<ShapeEntry> registered_l_shape(l_shape_entry());
  } // namespace
} // namespace abut
