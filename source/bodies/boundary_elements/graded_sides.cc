// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/plane_geometry.h>
#include <abut/bodies/boundary_elements/graded_sides.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    /// Halvings of an edge that leave no piece shorter than `shortest`.
    unsigned int halvings(const Segment &segment, const double shortest, const unsigned int wanted)
    {
      const double most = std::log2((segment.points.back() - segment.points.front()).norm() / shortest);
      return std::min(wanted, static_cast<unsigned int>(std::max(most, 0.)));
    }

    /// Places on an edge where it is cut, both ends included.
    std::vector<double> cuts(const bool starts_singular, const bool ends_singular, const unsigned int n)
    {
      std::vector<double> places{0., 1.};
      for (unsigned int k = 1; k <= n; ++k)
      {
        if (starts_singular)
          places.push_back(std::ldexp(1., -static_cast<int>(k)));
        if (ends_singular)
          places.push_back(1. - std::ldexp(1., -static_cast<int>(k)));
      }
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      return places;
    }
  } // namespace

  /// One graded side while it grows.
  struct GradedSides::Growing
  {
    std::vector<Segment> segments;
    std::vector<std::array<unsigned int, 2>> node_dofs;
    std::map<unsigned int, unsigned int> node_of_dof;

    unsigned int node(const std::array<unsigned int, 2> &dofs)
    {
      const auto next = static_cast<unsigned int>(node_of_dof.size());
      const auto [place, is_new] = node_of_dof.emplace(dofs[0], next);
      if (is_new)
        node_dofs.push_back(dofs);
      return place->second;
    }
  };

  GradedSides::GradedSides(const FiniteElementBody &body, const unsigned int n_splits,
                           const std::vector<bool> &cells)
      : n_dofs_(static_cast<unsigned int>(body.space().n_dofs()))
  {
    const BoundaryEdges boundary(body, SingularVertices::between_straight_edges, cells);
    boundaries_ = boundary.boundaries();
    std::vector<Vector2> starts;
    for (const BoundaryEdge &edge : boundary.edges())
      starts.push_back(edge.segment->points.front());
    const double shortest = 1e-7 * box_around(starts).diagonal();
    auto edge = boundary.edges().begin();
    for (const Trace *const side : boundary.sides())
    {
      Growing growing;
      pieces_.emplace_back();
      for (; edge != boundary.edges().end() && edge->side == side; ++edge)
        add_edge(*edge, halvings(*edge->segment, shortest, n_splits), growing);
      const auto geometry_degree = static_cast<unsigned int>(side->segments().front().points.size()) - 1;
      sides_.emplace_back(side->basis().degree(), geometry_degree, growing.segments, growing.node_dofs);
    }
  }

  void GradedSides::add_edge(const BoundaryEdge &edge, const unsigned int n, Growing &growing)
  {
    const Trace &side = *edge.side;
    const Segment &segment = *edge.segment;
    const auto index = static_cast<std::size_t>(edge.segment - side.segments().data());
    const LagrangeBasis geometry(static_cast<unsigned int>(segment.points.size()) - 1);
    const std::vector<double> places = cuts(edge.starts_singular, edge.ends_singular, n);
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
    {
      const double from = places[k], to = places[k + 1];
      Segment piece;
      piece.cell = segment.cell;
      for (const double s : geometry.nodes())
        piece.points.push_back(side.point(segment, from + (to - from) * s));
      for (std::size_t j = 0; j < segment.nodes.size(); ++j)
      {
        const bool is_first = j == 0, is_last = j + 1 == segment.nodes.size();
        if (is_first && k > 0)
          piece.nodes.push_back(growing.segments.back().nodes.back());
        else if (places.size() == 2 || is_first || (is_last && k + 2 == places.size()))
          piece.nodes.push_back(growing.node(side.node_dofs()[segment.nodes[j]]));
        else
          piece.nodes.push_back(
              growing.node(add_node(edge, from + (to - from) * side.basis().nodes()[static_cast<Index>(j)])));
      }
      growing.segments.push_back(piece);
      pieces_.back().push_back({index, from, to});
      singular_ends_.push_back(edge.ends_singular && k + 2 == places.size());
    }
  }

  std::array<unsigned int, 2> GradedSides::add_node(const BoundaryEdge &edge, const double s)
  {
    NewNode made{{}, edge.side->basis().values(s)};
    for (const unsigned int node : edge.segment->nodes)
      made.dofs.push_back(edge.side->node_dofs()[node]);
    const auto dof = n_dofs_ + 2 * static_cast<unsigned int>(new_nodes_.size());
    new_nodes_.push_back(made);
    return {{dof, dof + 1}};
  }

  Eigen::VectorXd GradedSides::extended(const Eigen::VectorXd &field) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(field.size() + 2 * static_cast<Index>(new_nodes_.size()));
    result.head(field.size()) = field;
    Index row = field.size();
    for (const NewNode &node : new_nodes_)
      for (unsigned int component = 0; component < 2; ++component, ++row)
        for (std::size_t j = 0; j < node.dofs.size(); ++j)
          result[row] += node.weights[static_cast<Index>(j)] * field[node.dofs[j][component]];
    return result;
  }
} // namespace abut
