// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bodies/boundary_elements/boundary_edges.h>

namespace abut
{
  /**
   * The sides of a body's mesh for boundary elements, with edges split towards vertices between straight
   * edges where data or geometry make the stress singular (BoundaryEdges): the pieces shrink to a share of
   * 2^-n of the edge. Elsewhere the edges are those of the mesh. Pieces are never shorter than 1e-7 of the
   * body.
   */
  class GradedSides
  {
  public:
    /// Where a graded segment lies on its side's own one.
    struct Piece
    {
      std::size_t segment;
      double from, to;
    };

    /// All sides of the body, or of those cells that are marked; with `n_splits` = 0 nothing is split.
    GradedSides(const FiniteElementBody &body, unsigned int n_splits, const std::vector<bool> &cells = {});

    /// New nodes have unknowns beyond those of the body: a field has to be `extended`.
    const std::vector<Trace> &sides() const { return sides_; }
    /// The boundary id of every side.
    const std::vector<dealii::types::boundary_id> &boundaries() const { return boundaries_; }
    /// Of every segment of a graded side.
    const std::vector<Piece> &pieces(const std::size_t side) const { return pieces_[side]; }
    /// Whether the vertex at the end of a segment is singular; all sides one after the other.
    const std::vector<bool> &singular_ends() const { return singular_ends_; }
    /// A field of the body (all unknowns) with its values at the new nodes.
    Eigen::VectorXd extended(const Eigen::VectorXd &field) const;

  private:
    struct Growing;
    /// A new node: the values of an edge's nodes, weighted.
    struct NewNode
    {
      std::vector<std::array<unsigned int, 2>> dofs;
      Eigen::VectorXd weights;
    };

    /// Adds the pieces of an edge that is cut by halving `n` times.
    void add_edge(const BoundaryEdge &edge, unsigned int n, Growing &growing);
    /// A new node at s of an edge; returns its unknowns.
    std::array<unsigned int, 2> add_node(const BoundaryEdge &edge, double s);

    std::vector<dealii::types::boundary_id> boundaries_;
    std::vector<Trace> sides_;
    std::vector<std::vector<Piece>> pieces_;
    std::vector<bool> singular_ends_;
    unsigned int n_dofs_;
    std::vector<NewNode> new_nodes_;
  };
} // namespace abut
