// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/mesh/gmsh_content.h>
#include <abut/mesh/gmsh_mesh_size.h>

#include <algorithm>
#include <cstdlib>
#include <gmsh.h>

namespace abut
{
  namespace
  {
    struct Elements
    {
      unsigned int order = 0;
      std::size_t n_corners = 0, n_nodes = 0; // of each
      std::vector<std::size_t> nodes;
    };

    /// Those of a dimension, kind by kind; of one entity, or of all (-1).
    std::vector<Elements> elements(const int dimension, const int entity)
    {
      std::vector<int> types;
      std::vector<std::vector<std::size_t>> tags, nodes;
      gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
      std::vector<Elements> result;
      for (std::size_t i = 0; i < types.size(); ++i)
      {
        std::string name;
        int of_dimension = 0, order = 0, n_nodes = 0, n_corners = 0;
        std::vector<double> places;
        gmsh::model::mesh::getElementProperties(types[i], name, of_dimension, order, n_nodes, places,
                                                n_corners);
        result.push_back({static_cast<unsigned int>(order), static_cast<std::size_t>(n_corners),
                          static_cast<std::size_t>(n_nodes), nodes[i]});
      }
      return result;
    }

    std::vector<int> entities(const int dimension)
    {
      gmsh::vectorpair pairs;
      gmsh::model::getEntities(pairs, dimension);
      std::vector<int> numbers;
      for (const auto &pair : pairs)
        numbers.push_back(pair.second);
      return numbers;
    }

    void read_nodes(GmshContent &content)
    {
      std::vector<std::size_t> tags;
      std::vector<double> places, parameters;
      gmsh::model::mesh::getNodes(tags, places, parameters);
      for (std::size_t i = 0; i < tags.size(); ++i)
        content.nodes[tags[i]] = {{places[3 * i], places[3 * i + 1], places[3 * i + 2]}};
    }

    /// Of a geometry with physical surfaces, these alone are the part, as where Gmsh writes its mesh.
    bool leaves_out(const std::vector<int> &physical, const GmshContent &content)
    {
      gmsh::vectorpair all;
      gmsh::model::getPhysicalGroups(all, 2);
      return content.is_geometry && physical.empty() && !all.empty();
    }

    void read_cells(GmshContent &content)
    {
      for (const int surface : entities(2))
      {
        std::vector<int> physical;
        gmsh::model::getPhysicalGroupsForEntity(2, surface, physical);
        if (leaves_out(physical, content))
          continue;
        const int region = physical.empty() ? 0 : std::abs(physical.front());
        if (region != 0)
          gmsh::model::getPhysicalName(2, region, content.regions[region]);
        content.regions_overlap = content.regions_overlap || physical.size() > 1;
        for (const Elements &kind : elements(2, surface))
        {
          content.highest_order = std::max(content.highest_order, kind.order);
          for (auto node = kind.nodes.begin(); node != kind.nodes.end();
               node += static_cast<std::ptrdiff_t>(kind.n_nodes))
          {
            const auto corners_end = node + static_cast<std::ptrdiff_t>(kind.n_corners);
            content.cells.push_back({{node, corners_end}, region, {}});
            if (kind.order == 2)
              content.cells.back().between = {corners_end,
                                              corners_end + static_cast<std::ptrdiff_t>(kind.n_corners)};
          }
        }
      }
      content.has_solids = !elements(3, -1).empty() || (content.cells.empty() && !entities(3).empty());
    }

    std::vector<GmshContent::Side> sides_of_curve(const int curve)
    {
      std::vector<int> ids;
      gmsh::model::getPhysicalGroupsForEntity(1, curve, ids);
      std::vector<GmshContent::Side> sides;
      for (const int id : ids)
      {
        sides.push_back({std::abs(id), {}});
        gmsh::model::getPhysicalName(1, sides.back().id, sides.back().name);
      }
      return sides;
    }

    void read_edges(GmshContent &content)
    {
      gmsh::vectorpair physical_lines;
      gmsh::model::getPhysicalGroups(physical_lines, 1);
      for (const int curve : entities(1))
      {
        auto sides = sides_of_curve(curve);
        if (content.is_geometry && physical_lines.empty())
          sides = {{curve, {}}};
        if (sides.empty())
          continue;
        content.sides[curve] = sides;
        for (const Elements &kind : elements(1, curve))
          for (std::size_t i = 0; i < kind.nodes.size(); i += kind.n_nodes)
            content.edges.push_back({{{kind.nodes[i], kind.nodes[i + 1]}}, curve});
      }
    }

    /// The points of a curve next to those of a chord, or none where they are the same.
    std::vector<Vector2> points_on_curve(const int curve, const std::array<double, 3> &start,
                                         const std::array<double, 3> &end)
    {
      constexpr double straight = 1e-10; // of the length
      const LagrangeBasis basis(8);
      std::vector<double> chord, places, parameters;
      for (const double s : basis.nodes())
        for (std::size_t d = 0; d < 3; ++d)
          chord.push_back((1. - s) * start[d] + s * end[d]);
      gmsh::model::getClosestPoint(1, curve, chord, places, parameters);
      std::vector<Vector2> points{{start[0], start[1]}};
      double deviation = 0.;
      for (std::size_t i = 1; i < basis.degree(); ++i)
      {
        points.emplace_back(places[3 * i], places[3 * i + 1]);
        deviation = std::max(deviation, (points.back() - Vector2(chord[3 * i], chord[3 * i + 1])).norm());
      }
      points.emplace_back(end[0], end[1]);
      return deviation > straight * (points.back() - points.front()).norm() ? points : std::vector<Vector2>();
    }

    void read_curves(GmshContent &content)
    {
      for (const int curve : entities(1))
      {
        std::string type;
        gmsh::model::getType(1, curve, type);
        if (type == "Line")
          continue;
        for (const Elements &kind : elements(1, curve))
          for (std::size_t i = 0; i < kind.nodes.size(); i += kind.n_nodes)
          {
            const std::array<std::size_t, 2> ends{{kind.nodes[i], kind.nodes[i + 1]}};
            const auto points = points_on_curve(curve, content.nodes.at(ends[0]), content.nodes.at(ends[1]));
            if (!points.empty())
              content.curves[ends] = points;
          }
      }
    }
  } // namespace

  bool prepare_gmsh_geometry(const BodyDescription &body, const std::string &where)
  {
    if (!elements(2, -1).empty() || entities(2).empty() || !entities(3).empty())
      return false;
    set_gmsh_mesh_size(body.mesh_size, where);
    if (body.cell_type == CellType::quadrilaterals)
    {
      constexpr double all_quadrilaterals = 3; // after Blossom
      gmsh::option::setNumber("Mesh.RecombineAll", 1);
      gmsh::option::setNumber("Mesh.RecombinationAlgorithm", all_quadrilaterals);
    }
    return true;
  }

  void mesh_gmsh_geometry(const double size_factor)
  {
    gmsh::model::mesh::clear();
    gmsh::option::setNumber("Mesh.MeshSizeFactor", size_factor);
    gmsh::model::mesh::generate(2);
  }

  GmshContent read_gmsh_model(const bool is_geometry)
  {
    GmshContent content;
    content.is_geometry = is_geometry;
    read_nodes(content);
    read_cells(content);
    read_edges(content);
    if (is_geometry)
      read_curves(content);
    return content;
  }
} // namespace abut
