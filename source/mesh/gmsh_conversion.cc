// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/mesh/gmsh_conversion.h>
#include <abut/mesh/mesh_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut
{
  namespace
  {
    using Ends = std::array<std::size_t, 2>;

    Ends either_way(const std::size_t a, const std::size_t b)
    {
      return {{std::min(a, b), std::max(a, b)}};
    }

    /// The place in Regions, from 1 on, of every physical surface; 0: not there.
    std::map<int, unsigned int> materials_of_regions(const GmshContent &content, const BodyDescription &body,
                                                     const std::string &where)
    {
      if (content.regions_overlap && !body.regions.empty())
        throw UserError(where + ": one of its surfaces belongs to several physical surfaces, for Regions "
                                "allowed is one");
      std::map<int, unsigned int> materials{{0, 0}};
      std::string names;
      for (const auto &[number, name] : content.regions)
      {
        materials[number] = 0;
        names += (names.empty() ? "" : ", ") + to_string(GmshContent::Side{number, name});
      }
      for (std::size_t i = 0; i < body.regions.size(); ++i)
      {
        const std::string &asked = body.regions[i].region;
        std::vector<int> meant;
        for (const auto &[number, name] : content.regions)
          if (name == asked || std::to_string(number) == asked)
            meant.push_back(number);
        if (meant.empty())
          throw UserError(where + ": it has no region `" + asked + "` (Regions); its physical surfaces are " +
                          (names.empty() ? "none" : names));
        if (meant.size() > 1 || materials[meant.front()] != 0)
          throw UserError(where + ": `" + asked + "` (Regions) means " +
                          (meant.size() > 1 ? "several of its physical surfaces"
                                            : "a physical surface that Regions names already") +
                          "; they are " + names);
        materials[meant.front()] = static_cast<unsigned int>(i + 1);
      }
      return materials;
    }

    /// Makes cells, their boundary and its sides of what a file holds.
    class Conversion
    {
    public:
      /// The cells; what the user should hear of them.
      Conversion(const GmshContent &content, const BodyDescription &body, const std::string &where)
          : content_(content), material_of_region_(materials_of_regions(content, body, where))
      {
        const auto has_corners = [](const std::size_t n) {
          return [n](const GmshContent::Cell &cell) { return cell.corners.size() == n; };
        };
        const auto &cells = content.cells;
        const auto n_quadrilaterals = std::count_if(cells.begin(), cells.end(), has_corners(4));
        const bool triangles = std::any_of(cells.begin(), cells.end(), has_corners(3));
        mesh_.cell_type = triangles ? CellType::triangles : CellType::quadrilaterals;
        for (const auto &cell : cells)
          add(cell);
        if (triangles && n_quadrilaterals > 0)
          mesh_.warnings.push_back(
              {WarningCode::cells_cut,
               where + ": it mixes triangles and quadrilaterals; its " + std::to_string(n_quadrilaterals) +
                   " quadrilaterals are cut in two; " +
                   (content.is_geometry ? "another Mesh size may give quadrilaterals alone"
                                        : "let Gmsh recombine all of them or none")});
        if (content.regions.size() > 1 && body.regions.empty())
          mesh_.warnings.push_back(
              {WarningCode::one_material, where + ": it has " + std::to_string(content.regions.size()) +
                                              " physical surfaces, but all of the body has the one material "
                                              "of its section; others are named in Regions"});
      }

      const RawMesh &mesh() const { return mesh_; }
      /// Once the cells are known to be sound.
      void add_sides()
      {
        for (const auto &edge : content_.edges)
          curve_of_[either_way(edge.ends[0], edge.ends[1])] = edge.curve;
        const auto boundary = find_boundary_edges(mesh_);
        for (const auto &[ends, cell] : boundary)
          add_boundary_edge(ends[0], ends[1], mesh_.cell_materials[cell]);
        for (const auto &[nodes, curve] : content_.curves)
        {
          const auto start = number_.find(nodes[0]), end = number_.find(nodes[1]);
          if (start == number_.end() || end == number_.end())
            continue; // of no cell
          const std::array<unsigned int, 2> ends{{start->second, end->second}};
          if (boundary.count(ends) + boundary.count({{ends[1], ends[0]}}) == 0)
            mesh_.inner_edges.push_back({ends, 0, curve});
        }
      }
      /// The second-order nodes of the edges of the boundary; empty where none leaves its chord.
      std::vector<std::vector<Vector2>> between() const
      {
        constexpr double straight = 1e-10; // of the length
        std::vector<std::vector<Vector2>> result;
        bool leaves_chord = false;
        for (const auto &edge : mesh_.boundary_edges)
        {
          const Vector2 &a = mesh_.vertices[edge.vertices[0]], &b = mesh_.vertices[edge.vertices[1]];
          result.emplace_back();
          const auto node = between_.find(either_way(edge.vertices[0], edge.vertices[1]));
          if (node == between_.end())
            continue;
          result.back().push_back(node->second);
          const Vector2 chord = b - a, from_start = node->second - a;
          leaves_chord = leaves_chord || std::abs(cross(chord, from_start)) > straight * chord.squaredNorm();
        }
        return leaves_chord ? result : std::vector<std::vector<Vector2>>();
      }

    private:
      unsigned int vertex(const std::size_t node)
      {
        const auto [found, is_new] = number_.emplace(node, static_cast<unsigned int>(mesh_.vertices.size()));
        if (is_new)
        {
          const auto &p = content_.nodes.at(node);
          mesh_.vertices.emplace_back(p[0], p[1]);
          node_.push_back(node);
        }
        return found->second;
      }

      void add(const GmshContent::Cell &cell)
      {
        std::vector<unsigned int> around;
        for (const std::size_t node : cell.corners)
          around.push_back(vertex(node));
        for (std::size_t i = 0; i < cell.between.size(); ++i)
        {
          const auto &p = content_.nodes.at(cell.between[i]);
          between_[either_way(around[i], around[(i + 1) % around.size()])] = {p[0], p[1]};
        }
        double area = 0.;
        for (std::size_t i = 0; i < around.size(); ++i)
        {
          const Vector2 a = mesh_.vertices[around[i]] - mesh_.vertices[around[0]];
          const Vector2 b = mesh_.vertices[around[(i + 1) % around.size()]] - mesh_.vertices[around[0]];
          area += cross(a, b);
        }
        if (area < 0.)
          std::reverse(around.begin(), around.end());
        if (around.size() == 3)
          mesh_.cells.push_back(around);
        else if (mesh_.cell_type == CellType::quadrilaterals)
          mesh_.cells.push_back({around[0], around[1], around[3], around[2]});
        else
          add_halves(around);
        mesh_.cell_materials.resize(mesh_.cells.size(), material_of_region_.at(cell.region));
      }
      /// Cut along the shorter diagonal.
      void add_halves(const std::vector<unsigned int> &around)
      {
        const auto diagonal = [&](const std::size_t i) {
          return (mesh_.vertices[around[i + 2]] - mesh_.vertices[around[i]]).norm();
        };
        const std::size_t i = diagonal(0) <= diagonal(1) ? 0 : 1;
        mesh_.cells.push_back({around[i], around[i + 1], around[i + 2]});
        mesh_.cells.push_back({around[i + 2], around[(i + 3) % 4], around[i]});
      }

      void add_boundary_edge(const unsigned int start, const unsigned int end, const unsigned int material)
      {
        const Ends nodes{{node_[start], node_[end]}};
        const auto curve = curve_of_.find(either_way(nodes[0], nodes[1]));
        GmshContent::Side side;
        if (curve != curve_of_.end())
          side = content_.sides.at(curve->second).front();
        const auto id = static_cast<unsigned int>(side.id);
        mesh_.sides[std::to_string(side.id)] = id;
        if (!side.name.empty())
          mesh_.sides[side.name] = id;
        mesh_.boundary_edges.push_back({{{start, end}}, id, curve_points(nodes), material});
      }
      std::vector<Vector2> curve_points(const Ends &nodes) const
      {
        if (const auto found = content_.curves.find(nodes); found != content_.curves.end())
          return found->second;
        if (const auto turned = content_.curves.find({{nodes[1], nodes[0]}}); turned != content_.curves.end())
          return {turned->second.rbegin(), turned->second.rend()};
        return {};
      }

      const GmshContent &content_;
      const std::map<int, unsigned int> material_of_region_;
      std::map<Ends, int> curve_of_;
      std::map<std::size_t, unsigned int> number_; // vertex of a node
      std::vector<std::size_t> node_;              // of a vertex
      std::map<Ends, Vector2> between_;            // by vertices
      RawMesh mesh_;
    };

    void check_names(const GmshContent &content, const RawMesh &mesh, const std::string &where)
    {
      if (mesh.sides.size() == 1 && mesh.sides.begin()->second == 0)
        throw UserError(where + ": no edge of its boundary belongs to a physical line, so that no side can "
                                "be named");
      for (const auto &[curve, sides] : content.sides)
        for (const auto &side : sides)
          if (const auto found = mesh.sides.find(side.name);
              found != mesh.sides.end() && found->second != static_cast<unsigned int>(side.id))
            throw UserError(where + ": `" + side.name + "` is the name of its physical line " +
                            std::to_string(side.id) + " and also means line " +
                            std::to_string(found->second) + ", give it another name");
    }
  } // namespace

  namespace
  {
    /// Directions of the lines between materials, away from each vertex that they meet.
    std::map<unsigned int, std::vector<Vector2>> lines_between_materials(const RawMesh &mesh)
    {
      std::map<unsigned int, std::vector<Vector2>> away;
      const auto cells = cells_by_edge(mesh);
      for (const auto &[edge, cell] : cells)
      {
        const auto other = cells.find({{edge[1], edge[0]}});
        if (other != cells.end() && mesh.cell_materials[cell] != mesh.cell_materials[other->second])
          away[edge[0]].push_back(mesh.vertices[edge[1]] -
                                  mesh.vertices[edge[0]]); // the other way round: at its end
      }
      return away;
    }

    /// Of a mesh file, a round line between materials stays the polygon that it is.
    void warn_of_round_lines(RawMesh &mesh, const std::string &where)
    {
      constexpr double straight = 1e-4, sharp_corner = M_PI / 3.; // radians
      constexpr std::size_t several = 3;                          // fewer bends may be meant
      std::vector<Vector2> bends;
      for (const auto &[vertex, directions] : lines_between_materials(mesh))
        if (directions.size() == 2)
          if (const double turn = std::abs(turning(-directions[0], directions[1]));
              turn > straight && turn < sharp_corner)
            bends.push_back(mesh.vertices[vertex]);
      if (bends.size() < several)
        return;
      std::ostringstream text;
      text << where << ": the line between its materials bends at " << bends.size()
           << " places, one of them (" << bends[0].x() << ", " << bends[0].y()
           << "), and stays as meshed; a geometry file has it as a curve, a finer mesh has it better";
      mesh.warnings.push_back({WarningCode::facets, text.str()});
    }
  } // namespace

  ConvertedMesh convert(const GmshContent &content, const BodyDescription &body, const std::string &where)
  {
    Conversion conversion(content, body, where);
    check_cells(conversion.mesh(), where);
    check_unfolded(conversion.mesh(), where);
    if (!body.is_glued())
      check_connected(conversion.mesh(), where);
    conversion.add_sides();
    ConvertedMesh result{conversion.mesh(), conversion.between()};
    check_names(content, result.mesh, where);
    if (!content.is_geometry)
      warn_of_round_lines(result.mesh, where);
    return result;
  }
} // namespace abut
