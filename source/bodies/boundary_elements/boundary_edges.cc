// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/base/directions.h>
#include <abut/base/plane_geometry.h>
#include <abut/bodies/boundary_elements/boundary_edges.h>
#include <abut/bodies/finite_elements/cell_materials.h>
#include <abut/bodies/finite_elements/side_conditions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace abut
{
  namespace
  {
    constexpr double bend = .52; // 30 degrees: less may be a facet of a smooth curve

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
    /// Where one edge ends and another one begins.
    struct Vertex
    {
      const BoundaryEdge &before, &after;
      double angle; ///< by which the boundary turns to the left, between -pi and pi
      Vector2 normal_before, normal_after;
    };

    Vertex between_chords(const BoundaryEdge &before, const BoundaryEdge &after)
    {
      return {before, after, turning(chord(*before.segment), chord(*after.segment)),
              chord_normal(*before.segment), chord_normal(*after.segment)};
    }

    /// By the tangents; a boundary that goes on smoothly has one normal, although its edges stand for it.
    Vertex between_curves(const BoundaryEdge &before, const BoundaryEdge &after)
    {
      const Vector2 from = before.side->tangent(*before.segment, 1.).normalized(),
                    to = after.side->tangent(*after.segment, 0.).normalized();
      const double angle = turning(from, to);
      if (std::abs(angle) > bend)
        return {before, after, angle, outward_normal(from), outward_normal(to)};
      const Vector2 mean = outward_normal(from + to);
      return {before, after, angle, mean, mean};
    }

    /// The prescribed traction at s without what supports carry, where the outward normal is n.
    Vector2 free_traction(const SideConditions &conditions, const BoundaryEdge &edge, const double s,
                          const Vector2 &normal)
    {
      return free_part(conditions.supported(edge.boundary, normal),
                       conditions.traction(edge.boundary, edge.side->point(*edge.segment, s), normal));
    }

    double middle_traction(const SideConditions &conditions, const BoundaryEdge &edge)
    {
      return free_traction(conditions, edge, .5, chord_normal(*edge.segment)).norm();
    }

    /// Whether geometry, supports or loads make the stress infinite.
    bool is_singular(const SideConditions &conditions, const Vertex &vertex, const double largest_traction)
    {
      constexpr double near = 1e-6, jump = 1e-3;
      const BoundaryEdge &before = vertex.before, &after = vertex.after;
      if (vertex.angle < -bend || before.is_seam != after.is_seam)
        return true;
      const std::vector<Vector2> held_before = conditions.supported(before.boundary, vertex.normal_before),
                                 held_after = conditions.supported(after.boundary, vertex.normal_after);
      const std::size_t n_before = held_before.size(), n_after = held_after.size();
      if (vertex.angle > bend)
        return n_before != n_after && n_before * n_after == 0 && n_before + n_after == 2;
      if (n_before != n_after || supports_turn(held_before, held_after))
        return true;
      constexpr double infinite = 100.; // times the value in the middle of the edge: 1/sqrt(s) gives 700
      const Vector2 from_left = free_traction(conditions, before, 1. - near, vertex.normal_before),
                    from_right = free_traction(conditions, after, near, vertex.normal_after);
      return (from_right - from_left).norm() > jump * largest_traction ||
             from_left.norm() > infinite * middle_traction(conditions, before) ||
             from_right.norm() > infinite * middle_traction(conditions, after);
    }

    /// Whether an edge is held along its normal alone: a plane of symmetry.
    bool is_symmetric(const SideConditions &conditions, const BoundaryEdge &edge, const Vector2 &normal)
    {
      constexpr double parallel = 1e-3;
      const std::vector<Vector2> held = conditions.supported(edge.boundary, normal);
      return held.size() == 1 && std::abs(cross(held.front(), normal)) < parallel;
    }

    /// Whether a curved seam runs at a right angle into a plane of symmetry: beyond it goes on smoothly.
    bool is_mirrored_seam(const SideConditions &conditions, const Vertex &vertex)
    {
      constexpr double cosine = .1; // of the right angle
      const BoundaryEdge &before = vertex.before, &after = vertex.after;
      if (before.is_seam == after.is_seam || (is_straight(*before.segment) && is_straight(*after.segment)))
        return false;
      const bool is_right = vertex.angle > 0. && std::abs(std::cos(vertex.angle)) < cosine;
      return is_right && (before.is_seam ? is_symmetric(conditions, after, vertex.normal_after)
                                         : is_symmetric(conditions, before, vertex.normal_before));
    }

    /// Whether an interface of two materials ends there, and not at a plane of symmetry, across which it may
    /// go on straight.
    bool ends_interface(const SideConditions &conditions, const Vertex &vertex)
    {
      const Material &one = vertex.before.material, &other = vertex.after.material;
      if (one == other)
        return false;
      return std::abs(vertex.angle) > bend ||
             !is_symmetric(conditions, vertex.before, vertex.normal_before) ||
             !is_symmetric(conditions, vertex.after, vertex.normal_after);
    }

    bool is_singular(const SideConditions &conditions, const BoundaryEdge &before, const BoundaryEdge &after,
                     const double largest_traction, const SingularVertices which)
    {
      if (which == SingularVertices::between_straight_edges)
        return is_straight(*before.segment) && is_straight(*after.segment) &&
               is_singular(conditions, between_chords(before, after), largest_traction);
      const Vertex vertex = between_curves(before, after);
      return !is_mirrored_seam(conditions, vertex) &&
             (is_singular(conditions, vertex, largest_traction) || ends_interface(conditions, vertex));
    }
  } // namespace

  unsigned int BoundaryEdge::dof(const unsigned int node) const
  {
    return side->node_dofs()[node][0];
  }

  BoundaryEdges::BoundaryEdges(const FiniteElementBody &body, const SingularVertices which,
                               const std::vector<bool> &cells)
  {
    std::vector<std::pair<Vector2, std::array<unsigned int, 2>>> vertices;
    const auto is_own = [&](const Segment &segment) { return cells.empty() || cells[segment.cell]; };
    for (const auto boundary : body.space().boundary_ids())
    {
      const Trace *side = &body.space().trace(boundary);
      if (std::none_of(side->segments().begin(), side->segments().end(), is_own))
        continue;
      boundaries_.push_back(boundary);
      if (body.space().has_free_vertices())
        side = &closed_.emplace_back(with_common_vertices(*side, vertices));
      sides_.push_back(side);
    }
    const std::vector<Material> materials = materials_of_cells(body);
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (const Segment &segment : sides_[i]->segments())
        if (is_own(segment))
          edges_.push_back({sides_[i], &segment, boundaries_[i], materials[segment.cell],
                            ends_at_glue(body.space(), boundaries_[i])});
    mark_singular_vertices(body, which);
  }

  void BoundaryEdges::mark_singular_vertices(const FiniteElementBody &body, const SingularVertices which)
  {
    const SideConditions conditions(body);
    double largest = 0.;
    std::map<unsigned int, BoundaryEdge *> starting_at;
    for (BoundaryEdge &edge : edges_)
    {
      starting_at[edge.dof(edge.segment->nodes.front())] = &edge;
      largest = std::max(largest, middle_traction(conditions, edge));
    }
    for (BoundaryEdge &edge : edges_)
    {
      const auto next = starting_at.find(edge.dof(edge.segment->nodes.back()));
      if (next != starting_at.end())
        edge.ends_singular = next->second->starts_singular =
            is_singular(conditions, edge, *next->second, largest, which);
    }
  }

  std::vector<Vector2> singular_vertices(const FiniteElementBody &body, const SingularVertices which)
  {
    const BoundaryEdges boundary(body, which);
    std::vector<Vector2> places;
    for (const BoundaryEdge &edge : boundary.edges())
      if (edge.ends_singular)
        places.push_back(edge.segment->points.back());
    return places;
  }
} // namespace abut
