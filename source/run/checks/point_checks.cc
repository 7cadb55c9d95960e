// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What can be said of a stress at a point.

#include <abut/run/checks/validity.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace abut
{
  namespace
  {
    constexpr double same_place = 1e-6; // of the smallest cell

    double smallest_cell(const Body &body)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const CellInfo &cell : body.cells())
        smallest = std::min(smallest, cell.diameter);
      return smallest;
    }

    bool is_singular(const PointResult &point)
    {
      const std::vector<Vector2> vertices = point.body->singular_vertices();
      const double near = same_place * smallest_cell(*point.body);
      return std::any_of(vertices.begin(), vertices.end(),
                         [&](const Vector2 &vertex) { return (vertex - point.place).norm() <= near; });
    }
  } // namespace

  Warnings output_point_warnings(const std::vector<PointResult> &points)
  {
    Warnings warnings;
    for (const PointResult &point : points)
      if (is_singular(point))
      {
        std::ostringstream text;
        text.precision(3);
        text << "Body " << point.body->name() << ": the stress at (" << point.place.x() << ", "
             << point.place.y()
             << "), one of Output/Points, is infinite in the exact solution (a reentrant corner, a support "
                "that "
                "begins or ends, a shear load that jumps): its value is one of the mesh; name a point "
                "farther away";
        warnings.push_back({WarningCode::singular_stress, text.str()});
      }
    return warnings;
  }
} // namespace abut
