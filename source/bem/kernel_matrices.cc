// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/kernel_matrices.h>
#include <abut/bem/large_matrix.h>
#include <abut/bem/pair_integrator.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace abut
{
  namespace
  {
    /// Elements per tile: the blocks of two tiles, in all matrices, stay in the cache.
    constexpr std::size_t tile_size = 32;
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
    // The second element is mostly the later one: down its rows.
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j)
      {
        const Eigen::Index below = std::max(row + i, column + j), before = std::min(row + i, column + j);
        log(below, before) = integrals.log(i, j);
        even_real(below, before) = integrals.even_real(i, j);
        even_imag(below, before) = integrals.even_imag(i, j);
        double_layer(row + i, column + j) = integrals.double_layer(i, j);
        double_layer(column + j, row + i) = integrals.reversed(i, j);
      }
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
