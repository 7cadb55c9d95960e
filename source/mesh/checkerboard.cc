// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/mesh/checkerboard.h>

#include <algorithm>
#include <vector>

namespace abut
{
  namespace
  {
    using MeshCell = dealii::Triangulation<2>::active_cell_iterator;

    std::vector<std::vector<MeshCell>> cells_by_vertex(const dealii::Triangulation<2> &triangulation)
    {
      std::vector<std::vector<MeshCell>> cells(triangulation.n_vertices());
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          cells[cell->vertex_index(v)].push_back(cell);
      return cells;
    }

    bool share_face(const MeshCell &a, const MeshCell &b)
    {
      const auto faces = a->face_indices();
      return std::any_of(faces.begin(), faces.end(), [&](const unsigned int f) {
        return !a->at_boundary(f) && a->neighbor(f) == dealii::Triangulation<2>::cell_iterator(b);
      });
    }

    /// Of four cells around a vertex, 1 for the cell and the one across the vertex, -1 for the others; all 0
    /// where the cell has not two neighbours among them.
    Eigen::Vector4d signs(const MeshCell &cell, const std::vector<MeshCell> &around)
    {
      Eigen::Vector4d result = Eigen::Vector4d::Ones();
      for (Eigen::Index i = 0; i < 4; ++i)
        if (share_face(cell, around[static_cast<std::size_t>(i)]))
          result[i] = -1.;
      return result.sum() == 0. ? result : Eigen::Vector4d::Zero();
    }
  } // namespace

  Eigen::VectorXd checkerboard(const dealii::Triangulation<2> &triangulation, const Eigen::VectorXd &values)
  {
    AssertDimension(values.size(), static_cast<Eigen::Index>(triangulation.n_active_cells()));
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(values.size()), counts = sums;
    for (const auto &around : cells_by_vertex(triangulation))
    {
      if (around.size() != 4)
        continue;
      Eigen::Vector4d met;
      for (Eigen::Index i = 0; i < 4; ++i)
        met[i] = values[around[static_cast<std::size_t>(i)]->active_cell_index()];
      for (const auto &cell : around)
      {
        const Eigen::Vector4d sign = signs(cell, around);
        sums[cell->active_cell_index()] += sign.dot(met) / 4.;
        counts[cell->active_cell_index()] += sign.isZero() ? 0. : 1.;
      }
    }
    return sums.cwiseQuotient(counts.cwiseMax(1.));
  }
} // namespace abut
