// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/large_matrix.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <sys/mman.h>

namespace abut
{
  Eigen::MatrixXd large_matrix(const Eigen::Index rows, const Eigen::Index columns)
  {
    Assert(rows >= 0 && columns >= 0, dealii::ExcMessage("sizes are not negative"));
    constexpr std::uintptr_t page = 4096;
    Eigen::MatrixXd matrix(rows, columns);
    const auto data = reinterpret_cast<std::uintptr_t>(matrix.data());
    const std::uintptr_t first = (data + page - 1) / page * page,
                         end = (data + sizeof(double) * static_cast<std::uintptr_t>(matrix.size())) / page *
                               page;
    // No more than advice: without large pages all works as before.
#ifdef MADV_HUGEPAGE
    if (end > first)
      madvise(reinterpret_cast<void *>(first), end - first, MADV_HUGEPAGE);
#endif
    return matrix;
  }

  void complete_symmetric(Eigen::MatrixXd &matrix)
  {
    AssertDimension(matrix.rows(), matrix.cols());
    constexpr Eigen::Index tile_size = 64;
    for (Eigen::Index column = 0; column < matrix.cols(); column += tile_size)
    {
      const Eigen::Index width = std::min(tile_size, matrix.cols() - column);
      auto diagonal = matrix.block(column, column, width, width);
      diagonal.triangularView<Eigen::StrictlyUpper>() = diagonal.transpose();
      for (Eigen::Index row = column + width; row < matrix.rows(); row += tile_size)
      {
        const Eigen::Index height = std::min(tile_size, matrix.rows() - row);
        matrix.block(column, row, width, height) = matrix.block(row, column, height, width).transpose();
      }
    }
  }
} // namespace abut
