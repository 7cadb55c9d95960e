// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/gathered.h>
#include <abut/mesh/body_mesh.h>
#include <abut/mesh/own_cells.h>
#include <abut/mesh/quality.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut
{
  namespace
  {
    struct Circles
    {
      double circumscribed, inscribed; // diameters
    };

    Circles circles(const dealii::Point<2> &a, const dealii::Point<2> &b, const dealii::Point<2> &c)
    {
      const auto ab = b - a, ac = c - a;
      const double twice_area = std::abs(ab[0] * ac[1] - ab[1] * ac[0]);
      const double l1 = ab.norm(), l2 = ac.norm(), l3 = (c - b).norm();
      return {l1 * l2 * l3 / twice_area, 2. * twice_area / (l1 + l2 + l3)};
    }

    Circles extreme_circles(const dealii::CellAccessor<2> &cell)
    {
      Circles extreme{0., std::numeric_limits<double>::infinity()};
      const unsigned int n = cell.n_vertices();
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = i + 1; j < n; ++j)
          for (unsigned int k = j + 1; k < n; ++k)
          {
            const Circles c = circles(cell.vertex(i), cell.vertex(j), cell.vertex(k));
            extreme.circumscribed = std::max(extreme.circumscribed, c.circumscribed);
            extreme.inscribed = std::min(extreme.inscribed, c.inscribed);
          }
      return extreme;
    }
  } // namespace

  MeshQuality mesh_quality(const BodyMesh &mesh)
  {
    MeshQuality quality{0., 0., 0.};
    for (const auto &cell : own_cells(mesh.triangulation))
    {
      const Circles c = extreme_circles(*cell);
      quality.h_max = std::max(quality.h_max, c.circumscribed);
      quality.regularity = std::max(quality.regularity, c.circumscribed / c.inscribed);
      for (const unsigned int face : cell->face_indices())
        if (cell->at_boundary(face))
          quality.h_boundary = std::max(quality.h_boundary, cell->face(face)->diameter());
    }
    for (const MeshQuality &part : gathered<MeshQuality>(mesh.processes, {quality}))
    {
      quality.h_max = std::max(quality.h_max, part.h_max);
      quality.h_boundary = std::max(quality.h_boundary, part.h_boundary);
      quality.regularity = std::max(quality.regularity, part.regularity);
    }
    return quality;
  }
} // namespace abut
