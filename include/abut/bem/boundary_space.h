// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/bem/boundary_element.h>
#include <abut/bem/layer_operators.h>
#include <abut/trace/trace.h>

#include <Eigen/SparseCore>

#include <optional>
#include <vector>

namespace abut
{
  /**
   * The boundary of a body as boundary elements: the trace of its finite-element mesh, one straight element
   * for every edge, (25) of the paper, with continuous displacements of a given degree, (26), and
   * discontinuous tractions. Built from the active edges of all sides, it serves meshes with hanging nodes,
   * triangles, and bodies with holes.
   *
   * Lengths are scaled: the origin is the centre of the boundary's bounding box, the unit its diagonal. A
   * displacement vector holds the values at the nodes, first all x components, then all y components;
   * densities hold Legendre coefficients in the order of LayerOperators.
   */
  class BoundarySpace
  {
  public:
    /// `sides`: all sides of the body, in any order. Throws ComputationError where edges do not close up.
    BoundarySpace(const std::vector<Trace> &sides, unsigned int displacement_degree,
                  unsigned int density_degree);

    const std::vector<BoundaryElement> &elements() const { return elements_; }
    Eigen::Index n_elements() const { return static_cast<Eigen::Index>(elements_.size()); }
    /// Degree of the Legendre polynomials that hold tractions and displacements.
    unsigned int density_degree() const { return density_degree_; }
    /// Coefficients of one component.
    Eigen::Index n_coefficients() const { return n_elements() * (density_degree_ + 1); }
    Eigen::Index n_nodes() const { return static_cast<Eigen::Index>(node_places_.size()); }
    /// The nodes of an element from its start to its end. Vertices have the first numbers.
    const std::vector<unsigned int> &nodes(const std::size_t element) const { return nodes_[element]; }
    const std::vector<Complex> &node_places() const { return node_places_; }
    /// The element that begins where this one ends.
    std::size_t next(const std::size_t element) const { return next_[element]; }
    /// Index of the side that an element is part of.
    std::size_t side(const std::size_t element) const { return sides_[element]; }
    /// Whether the boundary turns by more than 30 degrees at the end of an element.
    bool is_corner(std::size_t element) const;

    /// Displacements and their derivatives along the boundary from a displacement vector.
    const DisplacementBasis &displacements() const { return displacements_; }

    /// The displacement vector of a finite-element field (all unknowns), scaled.
    Eigen::VectorXd trace_of(const Eigen::VectorXd &field) const;

    Complex scaled(const Vector2 &point) const
    {
      return (Complex(point.x(), point.y()) - centre_) / unit_length_;
    }
    double unit_length() const { return unit_length_; }
    Complex centre() const { return centre_; }

  private:
    void connect(const std::vector<std::array<unsigned int, 2>> &ends);
    void make_elements(const std::vector<std::array<Vector2, 2>> &ends);
    void number_nodes(const std::vector<std::array<unsigned int, 2>> &ends, unsigned int degree);
    void make_displacements(unsigned int degree);
    void make_trace(const std::vector<Trace> &sides, unsigned int degree);

    unsigned int density_degree_;
    Complex centre_ = 0.;
    double unit_length_ = 1.;
    std::vector<BoundaryElement> elements_;
    std::vector<std::size_t> next_, sides_;
    std::vector<std::vector<unsigned int>> nodes_;
    std::vector<Complex> node_places_;
    DisplacementBasis displacements_;
    Eigen::SparseMatrix<double> trace_; ///< displacement vector (not scaled) from a finite-element field
  };
} // namespace abut
