// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/gathered.h>
#include <abut/mesh/own_cells.h>
#include <abut/trace/make_trace.h>

#include <deal.II/fe/fe.h>

#include <algorithm>
#include <map>

namespace abut
{
  namespace
  {
    using Cell = dealii::DoFHandler<2>::active_cell_iterator;

    /// A boundary face of a cell with its two ends in the order that has the body on the left.
    struct Ends
    {
      dealii::Point<2> unit_start, unit_end; // on the reference cell
      unsigned int start_vertex, end_vertex; // of the cell
    };

    Ends ends_of(const MeshEdge &edge)
    {
      const auto reference = edge.cell->reference_cell();
      const unsigned int a = reference.face_to_cell_vertices(edge.face, 0, 1);
      const unsigned int b = reference.face_to_cell_vertices(edge.face, 1, 1);
      Ends ends{reference.vertex<2>(a), reference.vertex<2>(b), a, b};
      const dealii::Tensor<1, 2> along = ends.unit_end - ends.unit_start;
      const dealii::Tensor<1, 2> inward = reference.barycenter<2>() - ends.unit_start;
      if (along[0] * inward[1] - along[1] * inward[0] <
          0) // cells are positively oriented, as the reference cell is
      {
        std::swap(ends.unit_start, ends.unit_end);
        std::swap(ends.start_vertex, ends.end_vertex);
      }
      return ends;
    }

    /// What a trace has of an edge.
    struct Edge
    {
      unsigned int cell = 0, start = 0, end = 0; ///< numbers of the cell and of the vertices
      std::vector<Vector2> points;
      std::vector<unsigned int> dofs; ///< of its nodes from start to end, two each

      void serialize(Archive &archive) { archive(cell, start, end, points, dofs); }
    };

    /// Orders the edges head to tail; open curves begin at the vertex where no edge ends.
    std::vector<Edge> chain(const std::vector<Edge> &edges)
    {
      std::map<unsigned int, std::size_t> starting_at;
      std::map<unsigned int, std::size_t> ending_at;
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        starting_at[edges[i].start] = i;
        ending_at[edges[i].end] = i;
      }
      std::vector<Edge> ordered;
      std::vector<bool> taken(edges.size(), false);
      const auto follow = [&](std::size_t i) {
        while (!taken[i])
        {
          taken[i] = true;
          ordered.push_back(edges[i]);
          const auto next = starting_at.find(edges[i].end);
          if (next == starting_at.end())
            return;
          i = next->second;
        }
      };
      for (std::size_t i = 0; i < edges.size(); ++i)
        if (ending_at.count(edges[i].start) == 0)
          follow(i);
      for (std::size_t i = 0; i < edges.size(); ++i) // what is left is closed
        follow(i);
      return ordered;
    }

    struct FaceDof
    {
      double s;
      unsigned int component;
      unsigned int dof;
    };

    /// The unknowns on an edge, sorted by their place s and component.
    std::vector<unsigned int> face_dofs(const Cell &cell, const Ends &ends)
    {
      const auto &fe = cell->get_fe();
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      const dealii::Tensor<1, 2> along = ends.unit_end - ends.unit_start;
      std::vector<FaceDof> found;
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        // Not has_support_on_face: for triangles deal.II 9.4 answers true, whatever the face.
        const dealii::Tensor<1, 2> from_start = fe.unit_support_point(i) - ends.unit_start;
        if (std::abs(along[0] * from_start[1] - along[1] * from_start[0]) < 1e-8)
          found.push_back({from_start * along / along.norm_square(), fe.system_to_component_index(i).first,
                           static_cast<unsigned int>(dofs[i])});
      }
      std::sort(found.begin(), found.end(), [](const FaceDof &a, const FaceDof &b) {
        return std::abs(a.s - b.s) > 1e-8 ? a.s < b.s : a.component < b.component;
      });
      std::vector<unsigned int> sorted;
      for (const FaceDof &dof : found)
        sorted.push_back(dof.dof);
      return sorted;
    }

    Edge edge_of(const MeshEdge &mesh_edge, const CellGeometry &geometry,
                 const Eigen::VectorXd &geometry_nodes)
    {
      const Cell &cell = mesh_edge.cell;
      const Ends ends = ends_of(mesh_edge);
      Edge edge;
      edge.cell = cell->global_active_cell_index();
      edge.start = cell->vertex_index(ends.start_vertex);
      edge.end = cell->vertex_index(ends.end_vertex);
      for (const double s : geometry_nodes)
        edge.points.push_back(
            geometry(cell, dealii::Point<2>(ends.unit_start + s * (ends.unit_end - ends.unit_start))));
      edge.dofs = face_dofs(cell, ends);
      AssertDimension(edge.dofs.size(), 2 * (cell->get_fe().degree + 1));
      return edge;
    }

    std::vector<Edge> edges_of(const std::vector<MeshEdge> &mesh_edges, const CellGeometry &geometry,
                               const unsigned int geometry_degree)
    {
      const LagrangeBasis geometry_basis(geometry_degree);
      std::vector<Edge> edges;
      for (const MeshEdge &edge : mesh_edges)
        edges.push_back(edge_of(edge, geometry, geometry_basis.nodes()));
      return edges;
    }

    Trace joined(const std::vector<Edge> &edges, const unsigned int degree,
                 const unsigned int geometry_degree)
    {
      Assert(!edges.empty(), dealii::ExcMessage("a curve has edges"));
      std::vector<Segment> segments;
      std::vector<std::array<unsigned int, 2>> node_dofs;
      std::map<unsigned int, unsigned int> node_of_dof;
      for (Edge &edge : chain(edges))
      {
        Segment segment;
        segment.cell = edge.cell;
        segment.points = std::move(edge.points);
        for (std::size_t i = 0; i < edge.dofs.size(); i += 2)
        {
          const auto [node, is_new] =
              node_of_dof.emplace(edge.dofs[i], static_cast<unsigned int>(node_dofs.size()));
          if (is_new)
            node_dofs.push_back({{edge.dofs[i], edge.dofs[i + 1]}});
          segment.nodes.push_back(node->second);
        }
        segments.push_back(std::move(segment));
      }
      return Trace(degree, geometry_degree, std::move(segments), std::move(node_dofs));
    }

    /// Those of all processes, which know a vertex by its first unknown.
    std::vector<Edge> everybodys(const std::shared_ptr<Processes> &processes, std::vector<Edge> edges)
    {
      if (!processes)
        return edges;
      for (Edge &edge : edges)
      {
        edge.start = edge.dofs.front();
        edge.end = edge.dofs[edge.dofs.size() - 2];
      }
      return gathered(processes, std::move(edges));
    }
  } // namespace

  Trace make_trace(const dealii::DoFHandler<2> &dof_handler, const CellGeometry &geometry,
                   const unsigned int geometry_degree, const dealii::types::boundary_id boundary,
                   const std::shared_ptr<Processes> &processes)
  {
    std::vector<MeshEdge> edges;
    for (const auto &cell : own_cells(dof_handler))
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
          edges.push_back({cell, face});
    return joined(everybodys(processes, edges_of(edges, geometry, geometry_degree)),
                  dof_handler.get_fe().degree, geometry_degree);
  }

  Trace make_trace(const std::vector<MeshEdge> &edges, const CellGeometry &geometry,
                   const unsigned int geometry_degree)
  {
    return joined(edges_of(edges, geometry, geometry_degree), edges.front().cell->get_fe().degree,
                  geometry_degree);
  }
} // namespace abut
