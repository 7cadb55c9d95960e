// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/trace/surface.h>

#include <Eigen/SparseCore>

namespace abut
{
  struct Atom;
  struct Run;

  /// A part of a surface that carries one multiplier.
  struct Part
  {
    double start = 0., end = 0.; ///< along the surface
    double length = 0.;          ///< of what is covered
    Vector2 middle = Vector2::Zero();
    /// Where its pressure stands: the carrier's node in it, its middle where there is not just one, the end
    /// of the stretch for the last part.
    Vector2 place = Vector2::Zero();
    double place_arc = 0.;             ///< along the surface
    std::size_t side = 0, segment = 0; ///< the cut side and its segment
    double s = 0., arc_length = 0.;    ///< on that segment, and on that side
  };

  /// Parts [first, last) that follow one another without a gap.
  struct Stretch
  {
    std::size_t first, last;
    bool closed;   ///< the last part is followed by the first
    double length; ///< of a closed one
  };

  /**
   * The interface cut into parts, each with one piecewise constant multiplier: non-negative functions, a
   * partition of unity on what is covered. The parts are the boxes of the side that carries the multipliers
   * (a box: the share of a node in its segments by the weights of the Gauss-Lobatto rule), which is chosen
   * piece by piece: with segment length by degree h and E' = E/(1 - nu^2), the finer side f carries where
   *
   *     E'_f h_c <= tau E'_c h_f,   c: the coarser side, tau = 1.5 for degree 1, 4 for 2 and 3,
   *
   * so that a stiff fine side does not have to follow the edges of the other's cells; of equally fine sides
   * the softer carries, of equal ones the first in the scene. A stretch ends where nothing lies opposite,
   * where the common normal turns by 45 degrees or where the other side has a step of a tenth of a segment.
   * While a part is shorter than .3 of the whole box it belongs to, it joins its shorter neighbour; a part
   * with a point that supports hold on both sides, where no pressure is defined, joins a neighbour too.
   *
   * Which of the sides is cut makes no difference on straight and parallel sides, but for round-off.
   */
  class Partition
  {
  public:
    Partition(const Surface &surface, const std::vector<CommonNormal> &normals);

    /// The pieces of the common refinement, cut at the ends of parts.
    const std::vector<Piece> &pieces() const { return pieces_; }
    const std::vector<Part> &parts() const { return parts_; }
    const std::vector<Stretch> &stretches() const { return stretches_; }
    const Stretch &stretch_of(std::size_t part) const;
    /// The neighbours of every part in its stretch: none, one or two.
    std::vector<std::vector<std::size_t>> neighbours() const;

    /**
     * The pressures that are reported, from the loads p_k >= 0 of the parts: what the nodes of the carrying
     * side get, q_k = int p phi_k / int phi_k with the sum phi_k of the shape functions of the nodes within
     * the part, (1, 6, 1)/8 of three neighbours on a uniform mesh of degree 1. Where there is no node around
     * which that side carries everywhere: the part's mean of the polyline through the p_k. Zero where p_k is;
     * never negative: what shape functions of higher degree make so at the end of contact is cut off.
     */
    Eigen::VectorXd reported_pressures(const Eigen::VectorXd &loads) const;

  private:
    void add_stretch(const std::vector<Run> &runs, const std::vector<Atom> &atoms,
                     const std::optional<double> &period);

    struct PlaceOnSide
    {
      std::size_t side, segment;
      double s, arc_length;
      Vector2 point;
    };
    /// A place of the surface, on one of the pieces [first, last).
    PlaceOnSide place_on_side(const Surface &surface, std::size_t first, std::size_t last, double arc) const;
    /// Finds the weights of the reported pressures; returns their centroids along the surface.
    Eigen::VectorXd find_node_shares(const Surface &surface, const std::vector<CommonNormal> &normals);
    void place_parts(const Surface &surface, const Eigen::VectorXd &centroids);

    std::vector<Piece> pieces_;
    std::vector<Part> parts_;
    std::vector<Stretch> stretches_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> node_shares_; ///< from loads to reported pressures
  };
} // namespace abut
