// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bodies/finite_elements/gathered_patches.h>

#include <deal.II/grid/reference_cell.h>

#include <array>

namespace abut
{
  namespace
  {
    /// What is shown of a cell, for other processes.
    struct ShownCell
    {
      std::array<Vector2, 4> corners;
      bool has_points = false;
      unsigned int n_subdivisions = 1;
      Eigen::MatrixXf values;

      void serialize(Archive &archive) { archive(corners, has_points, n_subdivisions, values); }
    };

    ShownCell to_shown(const dealii::DataOutBase::Patch<2> &patch)
    {
      ShownCell cell;
      for (unsigned int v = 0; v < 4; ++v)
        cell.corners[v] = Vector2(patch.vertices[v][0], patch.vertices[v][1]);
      cell.has_points = patch.points_are_available;
      cell.n_subdivisions = patch.n_subdivisions;
      cell.values.resize(static_cast<Eigen::Index>(patch.data.n_rows()),
                         static_cast<Eigen::Index>(patch.data.n_cols()));
      for (Eigen::Index i = 0; i < cell.values.rows(); ++i)
        for (Eigen::Index j = 0; j < cell.values.cols(); ++j)
          cell.values(i, j) = patch.data(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      return cell;
    }

    dealii::DataOutBase::Patch<2> to_patch(const ShownCell &cell, const unsigned int index)
    {
      dealii::DataOutBase::Patch<2> patch;
      patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
      for (unsigned int v = 0; v < 4; ++v)
        patch.vertices[v] = dealii::Point<2>(cell.corners[v].x(), cell.corners[v].y());
      patch.patch_index = index;
      patch.points_are_available = cell.has_points;
      patch.n_subdivisions = cell.n_subdivisions;
      patch.data.reinit(static_cast<std::size_t>(cell.values.rows()),
                        static_cast<std::size_t>(cell.values.cols()));
      for (Eigen::Index i = 0; i < cell.values.rows(); ++i)
        for (Eigen::Index j = 0; j < cell.values.cols(); ++j)
          patch.data(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = cell.values(i, j);
      return patch;
    }
  } // namespace

  std::vector<dealii::DataOutBase::Patch<2>>
  gathered_patches(const Space &space, const std::vector<dealii::DataOutBase::Patch<2>> &own)
  {
    std::vector<ShownCell> cells;
    for (const auto &patch : own)
      cells.push_back(to_shown(patch));
    std::vector<dealii::DataOutBase::Patch<2>> patches;
    for (const ShownCell &cell : space.gathered(std::move(cells)))
      patches.push_back(to_patch(cell, static_cast<unsigned int>(patches.size())));
    return patches;
  }
} // namespace abut
