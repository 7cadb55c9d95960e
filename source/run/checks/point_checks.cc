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

    bool is_singular(const Body &body, const Vector2 &place)
    {
      const std::vector<Vector2> vertices = body.singular_vertices();
      const double near = same_place * smallest_cell(body);
      return std::any_of(vertices.begin(), vertices.end(),
                         [&](const Vector2 &vertex) { return (vertex - place).norm() <= near; });
    }

    Warning infinite_stress(const Body &body, const Vector2 &place, const std::string &what)
    {
      std::ostringstream text;
      text.precision(3);
      text << "Body " << body.name() << ": the stress at (" << place.x() << ", " << place.y() << "), " << what
           << ", is infinite in the exact solution (a reentrant corner, a support that begins or ends, a "
              "shear "
              "load that jumps): its value is one of the mesh; name a point farther away";
      return {WarningCode::singular_stress, text.str()};
    }
  } // namespace

  Warnings output_point_warnings(const std::vector<PointResult> &points)
  {
    Warnings warnings;
    for (const PointResult &point : points)
      if (is_singular(*point.body, point.place))
        warnings.push_back(infinite_stress(*point.body, point.place, "one of Output/Points"));
    return warnings;
  }

  Warnings goal_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    if (scene.goal.kind == Goal::Kind::stress)
      for (const auto &body : model.bodies())
        if (!body->cells_at(scene.goal.point).empty() && is_singular(*body, scene.goal.point))
          warnings.push_back(infinite_stress(*body, scene.goal.point, "the Goal"));
    return warnings;
  }
} // namespace abut
