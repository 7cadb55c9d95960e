// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>
#include <abut/base/lagrange_basis.h>
#include <abut/base/vector2.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace abut
{
  /// Whether a curve turns by less than 45 degrees between two unit normals: more is a corner.
  inline bool is_smooth(const Vector2 &before, const Vector2 &after)
  {
    return before.dot(after) > std::sqrt(.5);
  }

  /// One boundary edge of a mesh, run through with the body on the left (counter-clockwise around it), s in
  /// [0, 1].
  struct Segment
  {
    std::vector<Vector2> points;     ///< at the Gauss-Lobatto nodes of the geometry's degree
    unsigned int cell = 0;           ///< active cell index of the cell behind it
    std::vector<unsigned int> nodes; ///< trace nodes that carry displacements, in the order of s
    double arc_start = 0.;           ///< arc length of s = 0 from the start of the curve
    double length = 0.;
    std::array<Vector2, 2> end_normals; ///< averaged outward unit normals at s = 0 and s = 1

    /// What a trace does not compute itself.
    void serialize(Archive &archive) { archive(points, cell, nodes); }
  };

  /**
   * One side of a body as a curve: the piece of a mesh's boundary that the other floors see. It carries the
   * trace of the finite-element space, nodes with two displacement components each; a vector on the trace has
   * the components 2 node and 2 node + 1. In two dimensions hanging nodes never lie on the boundary, so that
   * no node is constrained by others here.
   *
   * The geometry may be of higher degree than the space: the gap between curved bodies is that of the curves,
   * not of the chords.
   */
  class Trace
  {
  public:
    /// Without any segments: what another one is unpacked into.
    Trace() : Trace(1, 1, {}, {}) {}
    /**
     * The segments must be in order (each begins where the one before ends, except at the start of a new
     * curve); their lengths, arc positions and normals are computed here. `node_dofs` are the body's unknowns
     * of each node. Normals are averaged at vertices where the side turns by less than 45 degrees.
     */
    Trace(unsigned int degree, unsigned int geometry_degree, std::vector<Segment> segments,
          std::vector<std::array<unsigned int, 2>> node_dofs);

    /// Unpacked, it is the same to the last digit.
    void serialize(Archive &archive);

    const std::vector<Segment> &segments() const { return segments_; }
    const LagrangeBasis &basis() const { return basis_; }
    std::size_t n_nodes() const { return node_dofs_.size(); }
    const std::vector<std::array<unsigned int, 2>> &node_dofs() const { return node_dofs_; }

    const std::vector<Vector2> &node_points() const { return node_points_; }
    /// Outward unit normals: averaged at vertices, those of the geometry between them.
    const std::vector<Vector2> &node_normals() const { return node_normals_; }
    /// The outward unit normals at a node: one, or two where the side turns by 45 degrees or more.
    std::vector<Vector2> normals_at(std::size_t node) const;
    const std::vector<double> &node_arc_lengths() const { return node_arc_lengths_; }
    double length() const { return length_; }

    /// The segment that begins where this one ends; none at the end of an open curve.
    std::optional<std::size_t> following(std::size_t segment) const { return following_[segment]; }
    std::optional<std::size_t> preceding(std::size_t segment) const { return preceding_[segment]; }
    /// Whether the side turns by less than 45 degrees where `segment` ends and the following one begins.
    bool is_smooth_after(std::size_t segment) const;

    /// Tells, node by node, the projections on the directions along which supports prescribe the
    /// displacement (zero: free). An end that is held along the side alone is a plane of symmetry: its
    /// normal loses what it has along that direction.
    void set_supports(std::vector<Eigen::Matrix2d> projections);
    /// Whether supports prescribe the displacement of a point of the side along a direction (unit).
    bool is_held(const Segment &segment, double s, const Vector2 &direction) const;
    /// Whether supports hold an end of a segment (0: start, 1: end) along the side and not across it.
    bool is_plane_of_symmetry(const Segment &segment, std::size_t end) const;

    Vector2 point(const Segment &segment, double s) const;
    /// d point / ds; its length is the Jacobian of arc length.
    Vector2 tangent(const Segment &segment, double s) const;
    /// The displacement at a place, from those of the body's unknowns (see node_dofs).
    Vector2 displacement(const Segment &segment, double s, const Eigen::VectorXd &of_body) const;
    /// The averaged outward unit normal: interpolated between those of the segment's ends.
    static Vector2 averaged_normal(const Segment &segment, double s);

  private:
    Eigen::Matrix2d support_at(const Segment &segment, std::size_t end) const;
    void check_segments() const;
    void measure();
    void average_normals();
    void place_nodes();

    LagrangeBasis basis_;
    LagrangeBasis geometry_;
    std::vector<Segment> segments_;
    std::vector<std::array<unsigned int, 2>> node_dofs_;
    std::vector<Vector2> node_points_;
    std::vector<Vector2> node_normals_;
    std::map<std::size_t, std::array<Vector2, 2>> corner_normals_;
    std::vector<std::optional<std::size_t>> following_, preceding_;
    std::vector<Eigen::Matrix2d> supports_; ///< empty: none
    std::vector<double> node_arc_lengths_;
    double length_ = 0.;
  };
} // namespace abut
