// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_mesh_size.h>

#include <gmsh.h>
#include <sstream>
#include <vector>

namespace abut
{
  namespace
  {
    constexpr double growth = .25; // of the size, by distance

    /// The curves of a side, by its name or number; its own number where there are no physical lines.
    std::vector<double> curves_of(const std::string &side, const std::string &where)
    {
      gmsh::vectorpair lines, curves_alone;
      gmsh::model::getPhysicalGroups(lines, 1);
      if (lines.empty())
        gmsh::model::getEntities(curves_alone, 1);
      for (const auto &[dimension, number] : curves_alone)
        if (std::to_string(number) == side)
          return {static_cast<double>(number)};
      for (const auto &[dimension, number] : lines)
      {
        std::string name;
        gmsh::model::getPhysicalName(dimension, number, name);
        if (name != side && std::to_string(number) != side)
          continue;
        std::vector<int> curves;
        gmsh::model::getEntitiesForPhysicalGroup(dimension, number, curves);
        return {curves.begin(), curves.end()};
      }
      throw UserError(where + ": Mesh size names a side `" + side + "`, there is none");
    }

    /// The field `size + growth distance`, the distance being a formula of the library.
    int growing_field(const double size, const std::string &distance)
    {
      const int field = gmsh::model::mesh::field::add("MathEval");
      std::ostringstream formula;
      formula.precision(17);
      formula << size << "+" << growth << "*" << distance;
      gmsh::model::mesh::field::setString(field, "F", formula.str());
      return field;
    }

    std::string distance_from(const Vector2 &point)
    {
      std::ostringstream text;
      text.precision(17);
      text << "Sqrt((x-(" << point.x() << "))^2+(y-(" << point.y() << "))^2)";
      return text.str();
    }

    std::string distance_from(const std::vector<double> &curves)
    {
      const int field = gmsh::model::mesh::field::add("Distance");
      gmsh::model::mesh::field::setNumbers(field, "CurvesList", curves);
      gmsh::model::mesh::field::setNumber(field, "NumPointsPerCurve", 200);
      return "F" + std::to_string(field);
    }
  } // namespace

  void set_gmsh_mesh_size(const MeshSize &size, const std::string &where)
  {
    if (size.everywhere > 0.)
      gmsh::option::setNumber("Mesh.MeshSizeMax", size.everywhere);
    std::vector<double> fields;
    for (const auto &[side, local] : size.on_sides)
      fields.push_back(growing_field(local, distance_from(curves_of(side, where))));
    for (const auto &[point, local] : size.at_points)
      fields.push_back(growing_field(local, distance_from(point)));
    if (fields.empty())
      return;
    const int smallest = gmsh::model::mesh::field::add("Min");
    gmsh::model::mesh::field::setNumbers(smallest, "FieldsList", fields);
    gmsh::model::mesh::field::setAsBackgroundMesh(smallest);
  }
} // namespace abut
