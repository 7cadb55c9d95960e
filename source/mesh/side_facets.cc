// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/lagrange_basis.h>
#include <abut/base/plane_geometry.h>
#include <abut/mesh/side_facets.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    constexpr double sharp = 60.; // degrees: a hexagon's

    Vector2 chord(const RawMesh &mesh, const RawMesh::BoundaryEdge &edge)
    {
      return mesh.vertices[edge.vertices[1]] - mesh.vertices[edge.vertices[0]];
    }

    constexpr int samples_of_edge = 8;

    double height(const RawMesh &mesh, const RawMesh::BoundaryEdge &edge)
    {
      if (edge.curve.empty())
        return 0.;
      const Vector2 along = chord(mesh, edge).normalized();
      const LagrangeBasis basis(static_cast<unsigned int>(edge.curve.size()) - 1);
      double largest = 0.;
      for (int k = 1; k < samples_of_edge; ++k)
      {
        const Eigen::VectorXd values = basis.values(double(k) / samples_of_edge);
        Vector2 from_start = -mesh.vertices[edge.vertices[0]];
        for (std::size_t i = 0; i < edge.curve.size(); ++i)
          from_start += values[static_cast<Eigen::Index>(i)] * edge.curve[i];
        largest = std::max(largest, std::abs(cross(along, from_start)));
      }
      return largest;
    }

    /// The turn from an edge to the next of the same side, in degrees.
    double kink(const RawMesh &mesh, const RawMesh::BoundaryEdge &edge, const RawMesh::BoundaryEdge &next)
    {
      const Vector2 a = chord(mesh, edge), b = chord(mesh, next);
      return std::abs(turning(a, b)) * 180. / M_PI;
    }
  } // namespace

  std::map<unsigned int, SideFacets> side_facets(const RawMesh &mesh, const double corner_angle)
  {
    std::map<unsigned int, SideFacets> result;
    std::map<unsigned int, std::size_t> starting_at;
    for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i)
      starting_at[mesh.boundary_edges[i].vertices[0]] = i;
    const auto next_of = [&](const std::size_t i) {
      return starting_at.at(mesh.boundary_edges[i].vertices[1]);
    };
    const auto is_blunt = [&](const std::size_t i, const std::size_t next) {
      const auto &edge = mesh.boundary_edges[i], &after = mesh.boundary_edges[next];
      const double turn = kink(mesh, edge, after);
      return edge.side == after.side && turn >= corner_angle && turn < sharp;
    };
    for (std::size_t i = 0; i < mesh.boundary_edges.size(); ++i)
    {
      const auto &edge = mesh.boundary_edges[i];
      const std::size_t next = next_of(i);
      SideFacets &facets = result[edge.side];
      ++facets.n_edges;
      facets.height = std::max(facets.height, height(mesh, edge));
      if (edge.side == mesh.boundary_edges[next].side)
        facets.largest_kink = std::max(facets.largest_kink, kink(mesh, edge, mesh.boundary_edges[next]));
      if (is_blunt(i, next) && is_blunt(next, next_of(next)))
        ++facets.n_blunt_corners;
    }
    return result;
  }
} // namespace abut
