// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/kernel_matrices.h>
#include <abut/bem/large_matrix.h>
#include <abut/bem/pair_integrator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <utility>

namespace abut
{
  namespace
  {
    /// Elements per tile: the blocks of two tiles, in all matrices, stay in the cache.
    constexpr std::size_t tile_size = 32;

    // By pointers: there are very many small blocks.
    void set_block(const PairBlock &block, const Eigen::Index row, const Eigen::Index column,
                   Eigen::MatrixXd &matrix)
    {
      const Eigen::Index size = block.rows();
      const double *from = block.data();
      for (Eigen::Index j = 0; j < size; ++j)
      {
        double *const to = matrix.data() + (column + j) * matrix.rows() + row;
        for (Eigen::Index i = 0; i < size; ++i)
          to[i] = *from++;
      }
    }
    void set_transposed_block(const PairBlock &block, const Eigen::Index row, const Eigen::Index column,
                              Eigen::MatrixXd &matrix)
    {
      const Eigen::Index size = block.rows();
      for (Eigen::Index i = 0; i < size; ++i)
      {
        const double *const from = block.data() + i;
        double *const to = matrix.data() + (column + i) * matrix.rows() + row;
        for (Eigen::Index j = 0; j < size; ++j)
          to[j] = from[j * size];
      }
    }
  } // namespace

  KernelMatrices::KernelMatrices(const std::vector<BoundaryElement> &elements, const unsigned int degree)
      : degree(degree), lengths(static_cast<Eigen::Index>(elements.size()))
  {
    for (std::size_t m = 0; m < elements.size(); ++m)
      lengths[static_cast<Eigen::Index>(m)] = elements[m].length;
    resize(lengths.size() * (degree + 1), lengths.size() * (degree + 1));
  }

  void KernelMatrices::set(const std::size_t first, const std::size_t second, const PairIntegrals &integrals)
  {
    AssertIndexRange(static_cast<Eigen::Index>(first), lengths.size());
    AssertIndexRange(static_cast<Eigen::Index>(second), lengths.size());
    const Eigen::Index size = degree + 1, row = static_cast<Eigen::Index>(first) * size,
                       column = static_cast<Eigen::Index>(second) * size;
    for (auto &[matrix, block] : {std::pair(&log, &integrals.log),
                                  {&even_real, &integrals.even_real},
                                  {&even_imag, &integrals.even_imag}})
      if (first > second)
        set_block(*block, row, column, *matrix);
      else
        set_transposed_block(*block, column, row, *matrix);
    set_block(integrals.double_layer, row, column, double_layer);
    set_transposed_block(integrals.reversed, column, row, double_layer);
  }

  void KernelMatrices::complete()
  {
    for (Eigen::MatrixXd *matrix : {&log, &even_real, &even_imag})
      complete_symmetric(*matrix);
  }

  KernelMatrices kernel_matrices(const std::vector<BoundaryElement> &elements, const unsigned int degree,
                                 const GalerkinRule &rule)
  {
    KernelMatrices matrices(elements, degree);
    PairIntegrator integrator(elements, degree, rule);
    const auto set = [&](const std::size_t first, const std::size_t second, const PairIntegrals &integrals) {
      matrices.set(first, second, integrals);
    };
    const std::size_t n = elements.size();
    for (std::size_t rows = 0; rows < n; rows += tile_size)
      for (std::size_t columns = rows; columns < n; columns += tile_size)
        for (std::size_t m = rows; m < std::min(n, rows + tile_size); ++m)
          integrator.integrate(m, std::max(m, columns), std::min(n, columns + tile_size), set);
    matrices.complete();
    return matrices;
  }
} // namespace abut
