// SPDX-License-Identifier: LGPL-2.1-or-later
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
    struct Edge
    {
      Cell cell;
      dealii::Point<2> unit_start, unit_end; // on the reference cell
      unsigned int start_vertex, end_vertex;
    };

    Edge make_edge(const Cell &cell, const unsigned int face)
    {
      const auto reference = cell->reference_cell();
      const unsigned int a = reference.face_to_cell_vertices(face, 0, 1);
      const unsigned int b = reference.face_to_cell_vertices(face, 1, 1);
      Edge edge{cell, reference.vertex<2>(a), reference.vertex<2>(b), cell->vertex_index(a),
                cell->vertex_index(b)};
      const dealii::Tensor<1, 2> along = edge.unit_end - edge.unit_start;
      const dealii::Tensor<1, 2> inward = reference.barycenter<2>() - edge.unit_start;
      if (along[0] * inward[1] - along[1] * inward[0] <
          0) // cells are positively oriented, as the reference cell is
      {
        std::swap(edge.unit_start, edge.unit_end);
        std::swap(edge.start_vertex, edge.end_vertex);
      }
      return edge;
    }

    /// Orders the edges head to tail; open curves begin at the vertex where no edge ends.
    std::vector<Edge> chain(const std::vector<Edge> &edges)
    {
      std::map<unsigned int, std::size_t> starting_at;
      std::map<unsigned int, std::size_t> ending_at;
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        starting_at[edges[i].start_vertex] = i;
        ending_at[edges[i].end_vertex] = i;
      }
      std::vector<Edge> ordered;
      std::vector<bool> taken(edges.size(), false);
      const auto follow = [&](std::size_t i) {
        while (!taken[i])
        {
          taken[i] = true;
          ordered.push_back(edges[i]);
          const auto next = starting_at.find(edges[i].end_vertex);
          if (next == starting_at.end())
            return;
          i = next->second;
        }
      };
      for (std::size_t i = 0; i < edges.size(); ++i)
        if (ending_at.count(edges[i].start_vertex) == 0)
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
    std::vector<FaceDof> face_dofs(const Edge &edge)
    {
      const auto &fe = edge.cell->get_fe();
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      edge.cell->get_dof_indices(dofs);
      const dealii::Tensor<1, 2> along = edge.unit_end - edge.unit_start;
      std::vector<FaceDof> result;
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        // Not has_support_on_face: for triangles deal.II 9.4 answers true, whatever the face.
        const dealii::Tensor<1, 2> from_start = fe.unit_support_point(i) - edge.unit_start;
        if (std::abs(along[0] * from_start[1] - along[1] * from_start[0]) < 1e-8)
          result.push_back({from_start * along / along.norm_square(), fe.system_to_component_index(i).first,
                            static_cast<unsigned int>(dofs[i])});
      }
      std::sort(result.begin(), result.end(), [](const FaceDof &a, const FaceDof &b) {
        return std::abs(a.s - b.s) > 1e-8 ? a.s < b.s : a.component < b.component;
      });
      return result;
    }
  } // namespace

  Trace make_trace(const dealii::DoFHandler<2> &dof_handler, const CellGeometry &geometry,
                   const unsigned int geometry_degree, const dealii::types::boundary_id boundary)
  {
    std::vector<MeshEdge> edges;
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
          edges.push_back({cell, face});
    return make_trace(edges, geometry, geometry_degree);
  }

  Trace make_trace(const std::vector<MeshEdge> &mesh_edges, const CellGeometry &geometry,
                   const unsigned int geometry_degree)
  {
    Assert(!mesh_edges.empty(), dealii::ExcMessage("a curve has edges"));
    const unsigned int degree = mesh_edges.front().cell->get_fe().degree;
    std::vector<Edge> edges;
    for (const MeshEdge &edge : mesh_edges)
      edges.push_back(make_edge(edge.cell, edge.face));
    const LagrangeBasis geometry_basis(geometry_degree);
    std::vector<Segment> segments;
    std::vector<std::array<unsigned int, 2>> node_dofs;
    std::map<unsigned int, unsigned int> node_of_dof;
    for (const Edge &edge : chain(edges))
    {
      Segment segment;
      segment.cell = edge.cell->active_cell_index();
      for (const double s : geometry_basis.nodes())
      {
        segment.points.push_back(
            geometry(edge.cell, dealii::Point<2>(edge.unit_start + s * (edge.unit_end - edge.unit_start))));
      }
      const std::vector<FaceDof> dofs = face_dofs(edge);
      AssertDimension(dofs.size(), 2 * (degree + 1));
      for (std::size_t i = 0; i < dofs.size(); i += 2)
      {
        const auto [node, is_new] =
            node_of_dof.emplace(dofs[i].dof, static_cast<unsigned int>(node_dofs.size()));
        if (is_new)
          node_dofs.push_back({{dofs[i].dof, dofs[i + 1].dof}});
        segment.nodes.push_back(node->second);
      }
      segments.push_back(std::move(segment));
    }
    return Trace(degree, geometry_degree, std::move(segments), std::move(node_dofs));
  }
} // namespace abut
