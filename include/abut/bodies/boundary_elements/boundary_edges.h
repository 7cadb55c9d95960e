// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/bodies/finite_elements/finite_element_body.h>

#include <list>
#include <vector>

namespace abut
{
  /// Where singular vertices are looked for.
  enum class SingularVertices
  {
    between_straight_edges, ///< those that edges of boundary elements are graded to
    everywhere              ///< between curved edges as well, and where interfaces of materials end
  };

  /// An edge of the mesh on a body's boundary, and what holds on it.
  struct BoundaryEdge
  {
    const Trace *side;
    const Segment *segment;
    dealii::types::boundary_id boundary;
    Material material;
    bool is_seam; ///< glued, with a singular stress where the glue ends
    bool starts_singular = false, ends_singular = false;

    unsigned int dof(unsigned int node) const;
  };

  /**
   * The edges of a body's boundary and the vertices between them where geometry or data make the stress
   * singular: reentrant corners; convex corners between a side held in both directions and a free one;
   * vertices on a smooth boundary where a support begins, ends or changes its directions, or where the
   * prescribed traction jumps or is infinite; ends of seams. `everywhere` takes angles between tangents and
   * adds the ends of interfaces between materials that share vertices. Turns below 30 degrees count as
   * smooth.
   */
  class BoundaryEdges
  {
  public:
    /// All sides of the body, or of those cells that are marked.
    BoundaryEdges(const FiniteElementBody &body, SingularVertices which, const std::vector<bool> &cells = {});
    BoundaryEdges(const BoundaryEdges &) = delete;
    BoundaryEdges &operator=(const BoundaryEdges &) = delete;

    /// The boundary as closed curves.
    const std::vector<const Trace *> &sides() const { return sides_; }
    /// The boundary id of every side.
    const std::vector<dealii::types::boundary_id> &boundaries() const { return boundaries_; }
    /// All sides one after the other.
    const std::vector<BoundaryEdge> &edges() const { return edges_; }

  private:
    void mark_singular_vertices(const FiniteElementBody &body, SingularVertices which);

    std::vector<dealii::types::boundary_id> boundaries_;
    std::vector<const Trace *> sides_; // of the space, or
    std::list<Trace> closed_;          // with common vertices
    std::vector<BoundaryEdge> edges_;
  };

  /// The places of a body's singular vertices.
  std::vector<Vector2> singular_vertices(const FiniteElementBody &body, SingularVertices which);
} // namespace abut
