// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/base/plane_geometry.h>
#include <abut/mesh/flat_corners.h>
#include <abut/mesh/mesh_checks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut
{
  namespace
  {
    constexpr double flat_turn = M_PI / 18.; // the turn below which an angle is 180 degrees

    /// The direction of a boundary edge at its start (s = 0) or end (s = 1).
    Vector2 direction(const RawMesh &mesh, const RawMesh::BoundaryEdge &edge, const double s)
    {
      if (edge.curve.empty())
        return mesh.vertices[edge.vertices[1]] - mesh.vertices[edge.vertices[0]];
      const LagrangeBasis basis(static_cast<unsigned int>(edge.curve.size()) - 1);
      const Eigen::VectorXd derivatives = basis.derivatives(s);
      Vector2 sum = Vector2::Zero();
      for (std::size_t i = 0; i < edge.curve.size(); ++i)
        sum += derivatives[static_cast<Eigen::Index>(i)] * edge.curve[i];
      return sum;
    }

    struct FlatCorner
    {
      std::size_t cell;
      unsigned int before, vertex, after;
    };

    /// Boundary edges, and those inside both ways.
    std::vector<RawMesh::BoundaryEdge> curved_both_ways(const RawMesh &mesh)
    {
      std::vector<RawMesh::BoundaryEdge> edges = mesh.boundary_edges;
      for (const RawMesh::BoundaryEdge &edge : mesh.inner_edges)
      {
        edges.push_back(edge);
        edges.push_back(
            {{{edge.vertices[1], edge.vertices[0]}}, 0, {edge.curve.rbegin(), edge.curve.rend()}});
      }
      return edges;
    }

    std::vector<FlatCorner> flat_corners(const RawMesh &mesh)
    {
      const auto cell_beside = cells_by_edge(mesh);
      const std::vector<RawMesh::BoundaryEdge> edges = curved_both_ways(mesh);
      std::map<std::pair<unsigned int, std::size_t>, const RawMesh::BoundaryEdge *>
          starting; // at vertex, cell
      for (const auto &edge : edges)
        starting[{edge.vertices[0], cell_beside.at(edge.vertices)}] = &edge;
      std::vector<FlatCorner> corners;
      for (const auto &edge : edges)
      {
        const std::size_t cell = cell_beside.at(edge.vertices);
        const auto next = starting.find({edge.vertices[1], cell});
        if (next == starting.end() || (edge.curve.empty() && next->second->curve.empty()))
          continue;
        if (std::abs(turning(direction(mesh, edge, 1.), direction(mesh, *next->second, 0.))) < flat_turn)
          corners.push_back({cell, edge.vertices[0], edge.vertices[1], next->second->vertices[1]});
      }
      return corners;
    }

    double area(const RawMesh &mesh, const std::vector<unsigned int> &triangle)
    {
      const Vector2 &a = mesh.vertices[triangle[0]];
      return cross(mesh.vertices[triangle[1]] - a, mesh.vertices[triangle[2]] - a);
    }
  } // namespace

  std::optional<Vector2> flat_corner(const RawMesh &mesh)
  {
    const auto corners = flat_corners(mesh);
    if (corners.empty())
      return {};
    return mesh.vertices[corners.front().vertex];
  }

  void swap_flat_corners(RawMesh &mesh)
  {
    if (mesh.cell_type != CellType::triangles)
      return;
    for (const FlatCorner &corner : flat_corners(mesh))
    {
      // The ear (before, vertex, after) and the triangle behind its inner edge, whose third vertex is `far`.
      const auto neighbour = std::find_if(mesh.cells.begin(), mesh.cells.end(), [&](const auto &cell) {
        const auto has = [&](const unsigned int v) { return std::count(cell.begin(), cell.end(), v) > 0; };
        return has(corner.before) && has(corner.after) && !has(corner.vertex);
      });
      if (neighbour == mesh.cells.end())
        continue;
      const auto other = static_cast<std::size_t>(neighbour - mesh.cells.begin());
      const unsigned int far = *std::find_if(neighbour->begin(), neighbour->end(), [&](const unsigned int v) {
        return v != corner.before && v != corner.after;
      });
      const std::vector<unsigned int> first = {corner.before, corner.vertex, far},
                                      second = {corner.vertex, corner.after, far};
      const bool one_material =
          mesh.cell_materials.empty() || mesh.cell_materials[corner.cell] == mesh.cell_materials[other];
      if (!one_material || !(area(mesh, first) > 0.) || !(area(mesh, second) > 0.))
        continue;
      mesh.cells[corner.cell] = first;
      mesh.cells[other] = second;
    }
  }
} // namespace abut
