// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/base/user_error.h>
#include <abut/mesh/mesh_checks.h>

#include <functional>
#include <map>
#include <sstream>

namespace abut
{
  namespace
  {
    using Edge = std::array<unsigned int, 2>;

    /// Vertices of a cell, in the order in which they are met on the way around it.
    std::vector<unsigned int> counter_clockwise(const std::vector<unsigned int> &cell)
    {
      return cell.size() == 4 ? std::vector<unsigned int>{cell[0], cell[1], cell[3], cell[2]} : cell;
    }

    bool is_convex(const RawMesh &mesh, const std::vector<unsigned int> &cell)
    {
      constexpr double smallest_angle = 1e-10; // as a sine: below, rounding decides
      const auto around = counter_clockwise(cell);
      const std::size_t n = around.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        const Vector2 &corner = mesh.vertices[around[i]];
        const Vector2 next = mesh.vertices[around[(i + 1) % n]] - corner;
        const Vector2 previous = mesh.vertices[around[(i + n - 1) % n]] - corner;
        const double area = cross(next, previous);
        if (!(area > smallest_angle * next.norm() * previous.norm()))
          return false;
      }
      return true;
    }

    /// Calls back with the ends of every edge of every cell, the cell on the left, and the cell.
    void for_each_edge(const RawMesh &mesh,
                       const std::function<void(const Edge &edge, std::size_t cell)> &visit)
    {
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      {
        const auto around = counter_clockwise(mesh.cells[c]);
        for (std::size_t i = 0; i < around.size(); ++i)
          visit({{around[i], around[(i + 1) % around.size()]}}, c);
      }
    }
  } // namespace

  std::map<std::array<unsigned int, 2>, std::size_t> cells_by_edge(const RawMesh &mesh)
  {
    std::map<Edge, std::size_t> cells;
    for_each_edge(mesh, [&](const Edge &edge, const std::size_t cell) { cells[edge] = cell; });
    return cells;
  }

  void check_cells(const RawMesh &mesh, const std::string &where)
  {
    for (const auto &cell : mesh.cells)
      if (!is_convex(mesh, cell))
      {
        std::ostringstream message;
        message << where << ": a cell with a corner at (" << mesh.vertices[cell[0]].x() << ", "
                << mesh.vertices[cell[0]].y()
                << ") is too distorted (all its angles must be between 0 and 180 degrees)";
        throw BadCells(message.str());
      }
  }

  void check_unfolded(const RawMesh &mesh, const std::string &where)
  {
    std::map<Edge, std::size_t> seen;
    for_each_edge(mesh, [&](const Edge &edge, const std::size_t cell) {
      if (seen.emplace(edge, cell).second)
        return;
      const Vector2 place = .5 * (mesh.vertices[edge[0]] + mesh.vertices[edge[1]]);
      std::ostringstream message;
      message << where << ": two of its cells lie on each other at (" << place.x() << ", " << place.y()
              << "), the mesh is folded there or has a cell twice";
      throw BadCells(message.str());
    });
  }

  void check_connected(const RawMesh &mesh, const std::string &where)
  {
    const auto cell_at = cells_by_edge(mesh);
    std::vector<bool> reached(mesh.cells.size(), false);
    std::vector<std::size_t> waiting{0};
    reached[0] = true;
    while (!waiting.empty())
    {
      const auto around = counter_clockwise(mesh.cells[waiting.back()]);
      waiting.pop_back();
      for (std::size_t i = 0; i < around.size(); ++i)
      {
        const auto neighbour = cell_at.find({{around[(i + 1) % around.size()], around[i]}});
        if (neighbour == cell_at.end() || reached[neighbour->second])
          continue;
        reached[neighbour->second] = true;
        waiting.push_back(neighbour->second);
      }
    }
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (!reached[c])
      {
        const Vector2 &place = mesh.vertices[mesh.cells[c][0]];
        std::ostringstream message;
        message << where << ": it consists of several parts, a body must be one (parts that only look "
                << "connected have double nodes); one begins at (" << place.x() << ", " << place.y() << ")";
        throw UserError(message.str());
      }
  }

  std::map<std::array<unsigned int, 2>, std::size_t> find_boundary_edges(const RawMesh &mesh)
  {
    const auto cells = cells_by_edge(mesh);
    std::map<Edge, std::size_t> edges;
    for (const auto &[edge, cell] : cells)
      if (cells.count({{edge[1], edge[0]}}) == 0)
        edges[edge] = cell;
    return edges;
  }
} // namespace abut
