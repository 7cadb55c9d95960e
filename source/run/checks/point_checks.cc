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
              "shear load that jumps, an interface of materials that ends): its value is one of the mesh; "
              "name a point farther away";
      return {WarningCode::singular_stress, text.str()};
    }

    /// The stress along an interface between materials is another one on either side.
    Warning mean_stress(const Body &body, const Vector2 &place, const std::string &what,
                        const std::string &values)
    {
      std::ostringstream text;
      text.precision(3);
      text << "Body " << body.name() << ": (" << place.x() << ", " << place.y() << "), " << what
           << ", lies where materials meet; its stress is the mean of theirs" << values
           << ": name a point within the one that is meant";
      return {WarningCode::between_materials, text.str()};
    }

    std::string values_of(const std::vector<MaterialStress> &stresses)
    {
      std::ostringstream text;
      text.precision(4);
      for (const MaterialStress &own : stresses)
        text << (&own == &stresses.front() ? " (von Mises " : ", ") << own.stress.von_mises()
             << " where E = " << own.material.young_modulus << ", nu = " << own.material.poisson_ratio;
      text << ')';
      return text.str();
    }

    bool has_several_materials(const Body &body, const Vector2 &place)
    {
      const std::vector<unsigned int> cells = body.cells_at(place);
      const std::vector<CellInfo> all = body.cells();
      return std::any_of(cells.begin(), cells.end(), [&](const unsigned int cell) {
        return !(all[cell].material == all[cells.front()].material);
      });
    }
  } // namespace

  Warnings output_point_warnings(const std::vector<PointResult> &points)
  {
    Warnings warnings;
    for (const PointResult &point : points)
      if (is_singular(*point.body, point.place))
        warnings.push_back(infinite_stress(*point.body, point.place, "one of Output/Points"));
      else if (point.by_material.size() > 1)
        warnings.push_back(
            mean_stress(*point.body, point.place, "one of Output/Points", values_of(point.by_material)));
    return warnings;
  }

  Warnings goal_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    if (scene.goal.kind == Goal::Kind::stress)
      for (const auto &body : model.bodies())
      {
        if (body->cells_at(scene.goal.point).empty())
          continue;
        if (is_singular(*body, scene.goal.point))
          warnings.push_back(infinite_stress(*body, scene.goal.point, "the Goal"));
        else if (has_several_materials(*body, scene.goal.point))
          warnings.push_back(mean_stress(*body, scene.goal.point, "the Goal", ""));
      }
    return warnings;
  }
} // namespace abut
