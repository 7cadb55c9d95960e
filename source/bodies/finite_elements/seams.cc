// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/seams.h>

#include <array>
#include <map>
#include <utility>

namespace abut
{
  namespace
  {
    std::vector<MeshEdge> coarse_edges(const dealii::DoFHandler<2> &dof_handler)
    {
      std::vector<MeshEdge> edges;
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && cell->face(f)->has_children())
            edges.push_back({cell, f});
      return edges;
    }

    /// The edges of the finer cells along one of a coarser cell.
    std::vector<MeshEdge> edges_along(const MeshEdge &coarse)
    {
      std::vector<MeshEdge> edges;
      for (unsigned int child = 0; child < coarse.cell->face(coarse.face)->n_children(); ++child)
        edges.push_back({coarse.cell->neighbor_child_on_subface(coarse.face, child),
                         coarse.cell->neighbor_of_neighbor(coarse.face)});
      return edges;
    }

    /// Rows of edges of cells of one level that follow one another.
    std::vector<std::vector<MeshEdge>> rows_of(const std::vector<MeshEdge> &edges)
    {
      using Vertex = std::pair<int, unsigned int>; // with the level
      std::map<Vertex, std::vector<std::size_t>> at_vertex;
      const auto ends = [&](const std::size_t i) {
        const auto face = edges[i].cell->face(edges[i].face);
        const int level = edges[i].cell->level();
        return std::array<Vertex, 2>{{{level, face->vertex_index(0)}, {level, face->vertex_index(1)}}};
      };
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (const Vertex &vertex : ends(i))
          at_vertex[vertex].push_back(i);
      std::vector<bool> taken(edges.size(), false);
      std::vector<std::vector<MeshEdge>> rows;
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        if (taken[i])
          continue;
        rows.emplace_back();
        std::vector<std::size_t> waiting{i};
        taken[i] = true;
        while (!waiting.empty())
        {
          const std::size_t here = waiting.back();
          waiting.pop_back();
          rows.back().push_back(edges[here]);
          for (const Vertex &vertex : ends(here))
            if (at_vertex[vertex].size() == 2)
              for (const std::size_t next : at_vertex[vertex])
                if (!taken[next])
                {
                  taken[next] = true;
                  waiting.push_back(next);
                }
        }
      }
      return rows;
    }
  } // namespace

  std::vector<Seam> find_seams(const dealii::DoFHandler<2> &dof_handler, const CellGeometry &geometry,
                               const unsigned int geometry_degree, const MortarVertices vertices)
  {
    const std::vector<MeshEdge> coarse = coarse_edges(dof_handler);
    std::vector<std::vector<MeshEdge>> rows;
    if (vertices == MortarVertices::free)
      rows = rows_of(coarse);
    else
      for (const MeshEdge &edge : coarse)
        rows.push_back({edge});
    std::vector<Seam> seams;
    for (const std::vector<MeshEdge> &row : rows)
    {
      std::vector<MeshEdge> fine;
      for (const MeshEdge &edge : row)
        for (const MeshEdge &finer : edges_along(edge))
          fine.push_back(finer);
      seams.push_back(
          {make_trace(fine, geometry, geometry_degree), make_trace(row, geometry, geometry_degree)});
    }
    return seams;
  }
} // namespace abut
