// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/material.h>
#include <abut/base/vector2.h>

#include <array>
#include <iosfwd>
#include <limits>
#include <vector>

namespace abut
{
  struct BodyResult;

  /**
   * The stress of a solved body's finite elements without the body: on every cell, polynomials in its unit
   * coordinates for the place and the stress, of the elements' degree. They are those of the elements where
   * cells are parallelograms, else fitted to the stress at Gauss points.
   */
  class StressMap
  {
  public:
    /// Of a rigid body: empty.
    explicit StressMap(const BodyResult &result);
    /// As it was written. Sets the stream's failbit where that is not what it holds.
    explicit StressMap(std::istream &in);
    void write(std::ostream &out) const;

    /// At a point of the undeformed body, world frame. Beside the cells, where curves are met by other cells
    /// than those of the point: that of the nearest place. The map is not empty.
    Stress operator()(const Vector2 &place) const;

  private:
    static constexpr Eigen::Index n_fields = 6; ///< x, y, xx, yy, xy, zz
    using Fields = Eigen::Matrix<double, n_fields, 1>;

    /// A box around cells, and where its halves stand.
    struct Node
    {
      Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity()), high = -low;
      std::size_t first = 0, second = 0; ///< of a leaf: its cell is the first
      bool is_leaf = false;

      void include(const Vector2 &lowest, const Vector2 &highest)
      {
        low = low.cwiseMin(lowest);
        high = high.cwiseMax(highest);
      }
    };
    /// The best place so far.
    struct Nearest
    {
      double distance;
      std::size_t cell;
      Vector2 unit;
    };

    void fit(const BodyResult &result);
    void build_tree();
    std::size_t add_node(std::vector<std::size_t>::iterator begin, std::vector<std::size_t>::iterator end,
                         const std::vector<Node> &leaves);
    void search(std::size_t node, const Vector2 &place, Nearest &nearest) const;
    void search_cell(std::size_t cell, const Vector2 &place, Nearest &nearest) const;

    Eigen::VectorXd basis(const Vector2 &unit) const;
    Eigen::Matrix<double, Eigen::Dynamic, 2> basis_gradients(const Vector2 &unit) const;
    /// The nearest point of the unit cell.
    Vector2 inside(const Vector2 &unit) const;
    Eigen::Map<const Eigen::MatrixXd> coefficients(std::size_t cell) const;
    std::size_t n_cells() const;

    bool triangles_ = false;
    std::vector<std::array<int, 2>> powers_; ///< of the polynomials' terms
    Eigen::MatrixXd coefficients_;           ///< of all fields, a column for every cell
    std::vector<Node> tree_;                 ///< its last node is the root
  };

  /// Binary, of this machine.
  void write_matrix(std::ostream &out, const Eigen::MatrixXd &matrix);
  /// Sets the stream's failbit where there is none.
  Eigen::MatrixXd read_matrix(std::istream &in);
} // namespace abut
