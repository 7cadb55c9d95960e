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

  namespace
  {
    /// Of each of the points that are a body's; none of others.
    std::vector<Warnings> point_warnings(const Body &body, const std::vector<PointResult> &points)
    {
      std::vector<Warnings> warnings(points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const PointResult &point = points[i];
        if (point.body != &body)
          continue;
        if (is_singular(body, point.place))
          warnings[i] = {infinite_stress(body, point.place, "one of Output/Points")};
        else if (point.by_material.size() > 1)
          warnings[i] = {
              mean_stress(body, point.place, "one of Output/Points", values_of(point.by_material))};
      }
      return warnings;
    }

    Warnings goal_warnings(const Body &body, const Vector2 &place)
    {
      if (body.cells_at(place).empty())
        return {};
      if (is_singular(body, place))
        return {infinite_stress(body, place, "the Goal")};
      if (has_several_materials(body, place))
        return {mean_stress(body, place, "the Goal", "")};
      return {};
    }
  } // namespace

  Warnings output_point_warnings(const Model &model, const std::vector<PointResult> &points)
  {
    Warnings warnings;
    if (points.empty())
      return warnings;
    const auto of_bodies = model.executor().of_bodies(model.bodies().size(), [&](const std::size_t a) {
      return point_warnings(*model.bodies()[a], points);
    });
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const std::vector<Warnings> &of_body : of_bodies)
        append(warnings, of_body[i]);
    return warnings;
  }

  Warnings goal_warnings(const Scene &scene, const Model &model)
  {
    Warnings warnings;
    if (scene.goal.kind == Goal::Kind::stress)
      for (const Warnings &of_body :
           model.executor().of_bodies(model.bodies().size(), [&](const std::size_t a) {
             return goal_warnings(*model.bodies()[a], scene.goal.point);
           }))
        append(warnings, of_body);
    return warnings;
  }
} // namespace abut
