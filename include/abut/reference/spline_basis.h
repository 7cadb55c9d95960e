// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/reference/piecewise_pressure.h>

namespace abut
{
  /**
   * Even pressure shapes on the contact [-a, a] made of cubics with a continuous slope, continued evenly with
   * the period 2l as in SineBasis. The knots a (1 - (1 - i/n)^3), i = 0 ... n, gather at the edge, where a
   * pressure that is almost a square root bends. A shape has the value 1 and the slope 0 at one knot, or the
   * slope of that order and the value 0; both vanish at all other knots. The last shape is the value at the
   * edge a.
   */
  class SplineBasis
  {
  public:
    SplineBasis(double half_width, double length, Eigen::Index n_pieces);

    double half_width() const { return knots_(knots_.size() - 1); }
    double length() const { return length_; }
    Eigen::Index size() const { return quadrature_.cols(); }

    /// The values of the shapes at the nodes: a row for each node.
    const Eigen::MatrixXd &node_values() const { return node_values_; }
    /// Cosine amplitudes as in SineBasis, by the quadrature of the nodes.
    Eigen::MatrixXd modes(Eigen::Index n_modes) const;
    /// As in SineBasis.
    Eigen::RowVectorXd potential(double x) const;

    /// Nodes x_q in (0, a), and the matrix W with int_0^a b_j f dx = sum_q W_qj f(x_q): by 8 Gauss points on
    /// every piece.
    const Eigen::VectorXd &nodes() const { return nodes_; }
    const Eigen::MatrixXd &quadrature() const { return quadrature_; }

    /// The pressure with these factors of the shapes.
    PiecewisePressure pressure(const Eigen::VectorXd &coefficients) const;

  private:
    void make_nodes();

    double length_;
    Eigen::VectorXd knots_;
    std::vector<PiecewisePressure> shapes_;
    Eigen::VectorXd nodes_;
    Eigen::MatrixXd node_values_;
    Eigen::MatrixXd quadrature_;
  };
} // namespace abut
