// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/base/plane_geometry.h>
#include <abut/bodies/boundary_elements/graded_sides.h>
#include <abut/bodies/finite_elements/side_conditions.h>

#include <algorithm>
#include <cmath>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    Vector2 chord(const Segment &segment)
    {
      return segment.points.back() - segment.points.front();
    }

    Vector2 chord_normal(const Segment &segment)
    {
      return outward_normal(chord(segment));
    }

    bool is_straight(const Segment &segment)
    {
      const Vector2 normal = chord_normal(segment);
      return std::all_of(segment.points.begin(), segment.points.end(), [&](const Vector2 &point) {
        return std::abs(normal.dot(point - segment.points.front())) <= 1e-9 * chord(segment).norm();
      });
    }

    /// By how much the boundary turns to the left from one edge to the next, between -pi and pi.
    double turn(const Segment &before, const Segment &after)
    {
      return turning(chord(before), chord(after));
    }

    /// Whether single supported directions differ, where the boundary goes straight on.
    bool supports_turn(const std::vector<Vector2> &before, const std::vector<Vector2> &after)
    {
      constexpr double sine = .5; // normals of neighbouring edges differ by less
      return before.size() == 1 && after.size() == 1 && std::abs(cross(before[0], after[0])) > sine;
    }

    /// Whether a side is glued to another material, or to a side that goes on where it ends: a reentrant
    /// corner of both together.
    bool ends_at_glue(const Space &space, const dealii::types::boundary_id boundary)
    {
      return std::any_of(space.glued_sides().begin(), space.glued_sides().end(), [&](const GluedSides &pair) {
        return !pair.is_seamless && (pair.slave == boundary || pair.master == boundary);
      });
    }

    /// Halvings of an edge that leave no piece shorter than `shortest`.
    unsigned int halvings(const Segment &segment, const double shortest, const unsigned int wanted)
    {
      const double most = std::log2(chord(segment).norm() / shortest);
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

  /// An edge of the mesh and what holds on it.
  struct GradedSides::Edge
  {
    const Trace *side;
    const Segment *segment;
    dealii::types::boundary_id boundary;
    std::vector<Vector2> supported;
    bool is_seam; ///< glued, with a singular stress where the glue ends
    bool starts_singular = false, ends_singular = false;

    unsigned int dof(const unsigned int node) const { return side->node_dofs()[node][0]; }
    /// The prescribed traction at s without what supports carry.
    Vector2 traction(const SideConditions &conditions, const double s) const
    {
      return free_part(supported,
                       conditions.traction(boundary, side->point(*segment, s), chord_normal(*segment)));
    }
  };

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

  namespace
  {
    /// The boundary as closed curves: where cells and finer ones have displacements of their own at a common
    /// vertex, those of the first one stand for both.
    Trace with_common_vertices(const Trace &side,
                               std::vector<std::pair<Vector2, std::array<unsigned int, 2>>> &vertices)
    {
      constexpr double same = 1e-9; // of an edge
      std::vector<std::array<unsigned int, 2>> dofs = side.node_dofs();
      std::vector<Segment> segments = side.segments();
      for (const Segment &segment : segments)
        for (const auto &[node, place] : {std::pair(segment.nodes.front(), segment.points.front()),
                                          {segment.nodes.back(), segment.points.back()}})
        {
          const auto known =
              std::find_if(vertices.begin(), vertices.end(), [&, at = place](const auto &vertex) {
                return (vertex.first - at).norm() < same * segment.length;
              });
          if (known == vertices.end())
            vertices.emplace_back(place, dofs[node]);
          else
            dofs[node] = known->second;
        }
      return {side.basis().degree(), static_cast<unsigned int>(segments.front().points.size()) - 1, segments,
              dofs};
    }
  } // namespace

  GradedSides::GradedSides(const FiniteElementBody &body, const unsigned int n_splits,
                           const std::vector<bool> &cells)
      : n_dofs_(static_cast<unsigned int>(body.space().n_dofs()))
  {
    std::vector<std::pair<Vector2, std::array<unsigned int, 2>>> vertices;
    const auto is_own = [&](const Segment &segment) { return cells.empty() || cells[segment.cell]; };
    std::vector<Trace> sides;
    for (const auto boundary : body.space().mesh().triangulation.get_boundary_ids())
    {
      Trace side = body.space().trace(boundary);
      if (std::none_of(side.segments().begin(), side.segments().end(), is_own))
        continue;
      boundaries_.push_back(boundary);
      if (body.space().has_free_vertices())
        side = with_common_vertices(side, vertices);
      sides.push_back(std::move(side));
    }
    const SideConditions conditions(body);
    std::vector<Edge> edges;
    Vector2 low = sides.front().node_points().front(), high = low;
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (const Segment &segment : sides[i].segments())
      {
        if (!is_own(segment))
          continue;
        edges.push_back({&sides[i], &segment, boundaries_[i],
                         conditions.supported(boundaries_[i], chord_normal(segment)),
                         ends_at_glue(body.space(), boundaries_[i])});
        low = low.cwiseMin(segment.points.front());
        high = high.cwiseMax(segment.points.front());
      }
    find_singular_vertices(conditions, edges);
    const double shortest = 1e-7 * (high - low).norm();
    auto edge = edges.begin();
    for (const Trace &side : sides)
    {
      Growing growing;
      pieces_.emplace_back();
      for (std::size_t i = 0; i < side.segments().size(); ++i)
        if (is_own(side.segments()[i]))
        {
          add_edge(*edge, i, halvings(*edge->segment, shortest, n_splits), growing);
          ++edge;
        }
      const auto geometry_degree = static_cast<unsigned int>(side.segments().front().points.size()) - 1;
      sides_.emplace_back(side.basis().degree(), geometry_degree, growing.segments, growing.node_dofs);
    }
  }

  void GradedSides::find_singular_vertices(const SideConditions &conditions, std::vector<Edge> &edges)
  {
    double largest = 0.;
    std::map<unsigned int, Edge *> starting_at;
    for (Edge &edge : edges)
    {
      starting_at[edge.dof(edge.segment->nodes.front())] = &edge;
      largest = std::max(largest, edge.traction(conditions, .5).norm());
    }
    for (Edge &edge : edges)
    {
      const auto next = starting_at.find(edge.dof(edge.segment->nodes.back()));
      if (next != starting_at.end())
        edge.ends_singular = next->second->starts_singular =
            is_singular(conditions, edge, *next->second, largest);
    }
  }

  bool GradedSides::is_singular(const SideConditions &conditions, const Edge &before, const Edge &after,
                                const double largest_traction)
  {
    constexpr double near = 1e-6, jump = 1e-3, bend = .52; // 30 degrees
    const double angle = turn(*before.segment, *after.segment);
    if (!is_straight(*before.segment) || !is_straight(*after.segment))
      return false;
    if (angle < -bend || before.is_seam != after.is_seam)
      return true;
    const std::size_t n_before = before.supported.size(), n_after = after.supported.size();
    if (angle > bend)
      return n_before != n_after && n_before * n_after == 0 && n_before + n_after == 2;
    if (n_before != n_after || supports_turn(before.supported, after.supported))
      return true;
    constexpr double infinite = 100.; // times the value in the middle of the edge: 1/sqrt(s) gives 700
    const Vector2 from_left = before.traction(conditions, 1. - near),
                  from_right = after.traction(conditions, near);
    return (from_right - from_left).norm() > jump * largest_traction ||
           from_left.norm() > infinite * before.traction(conditions, .5).norm() ||
           from_right.norm() > infinite * after.traction(conditions, .5).norm();
  }

  void GradedSides::add_edge(const Edge &edge, const std::size_t index, const unsigned int n,
                             Growing &growing)
  {
    const Trace &side = *edge.side;
    const Segment &segment = *edge.segment;
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

  std::array<unsigned int, 2> GradedSides::add_node(const Edge &edge, const double s)
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

  std::vector<Vector2> singular_vertices(const FiniteElementBody &body)
  {
    const GradedSides graded(body, 0);
    std::vector<Vector2> places;
    auto singular = graded.singular_ends().begin();
    for (const Trace &side : graded.sides())
      for (const Segment &segment : side.segments())
        if (*singular++)
          places.push_back(segment.points.back());
    return places;
  }
} // namespace abut
