// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/bem/far_pairs.h>
#include <abut/bem/kernel_matrices.h>
#include <abut/bem/large_matrix.h>
#include <abut/bem/near_pairs.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abut
{
  namespace
  {
    /// Elements per tile: the blocks of two tiles, in all matrices, stay in the cache.
    constexpr std::size_t tile_size = 32;

    /// Fills the matrices tile by tile.
    class KernelFiller
    {
    public:
      KernelFiller(const std::vector<BoundaryElement> &elements, const unsigned int degree,
                   const GalerkinRule &rule)
          : elements_(elements), near_(rule, degree), far_(rule, degree),
            queues_(far_.n_tiers() * far_.n_tiers()), integrals_(degree), matrices_(elements, degree)
      {
        double largest = 0.;
        for (const BoundaryElement &element : elements)
          largest = std::max({largest, std::abs(element.start), std::abs(element.end)});
        round_off_ = 4. * std::numeric_limits<double>::epsilon() * largest;
      }

      KernelMatrices fill()
      {
        const std::size_t n = elements_.size();
        for (std::size_t rows = 0; rows < n; rows += tile_size)
          for (std::size_t columns = rows; columns < n; columns += tile_size)
            for (std::size_t m = rows; m < std::min(n, rows + tile_size); ++m)
              fill_row(m, std::max(m, columns), std::min(n, columns + tile_size));
        return std::move(matrices_);
      }

    private:
      /// The pairs of m with first ... end - 1.
      void fill_row(const std::size_t m, const std::size_t first, const std::size_t end)
      {
        for (std::size_t l = first; l < end; ++l)
          if (l == m)
            matrices_.set(m, m, self_integrals(elements_[m], matrices_.degree));
          else if (!queue_far(m, l))
            fill_near(m, l);
        for (std::size_t tiers = 0; tiers < queues_.size(); ++tiers)
          fill_far(m, tiers);
      }

      /// Puts l into one of m's queues if both are far from each other.
      bool queue_far(const std::size_t m, const std::size_t l)
      {
        const BoundaryElement &a = elements_[m], &b = elements_[l];
        const double longest = std::max(a.length, b.length);
        // Not more than the distance, and cheap.
        double apart =
            .5 * (std::sqrt(std::norm((a.start - b.start) + (a.end - b.end))) - a.length - b.length);
        if (far_.tier(apart, longest) < 0)
          apart = distance(a, b);
        if (far_.tier(apart, longest) < 0)
          return false;
        const auto first = static_cast<std::size_t>(far_.tier(apart, a.length)),
                   second = static_cast<std::size_t>(far_.tier(apart, b.length)),
                   tiers = first * far_.n_tiers() + second;
        queues_[tiers].push_back(l);
        if (queues_[tiers].size() == FarPairs::n_lanes)
          fill_far(m, tiers);
        return true;
      }

      void fill_near(const std::size_t m, const std::size_t l)
      {
        const BoundaryElement &a = elements_[m], &b = elements_[l];
        const bool flat = collinear(a, b, round_off_);
        if (a.length <= b.length)
          matrices_.set(m, l, near_.integrate(a, b, flat));
        else
          matrices_.set(l, m, near_.integrate(b, a, flat));
      }

      /// Empties a queue; lanes to spare repeat its last element.
      void fill_far(const std::size_t m, const std::size_t tiers)
      {
        std::vector<std::size_t> &queue = queues_[tiers];
        if (queue.empty())
          return;
        FarPairs::Partners partners;
        for (std::size_t lane = 0; lane < partners.size(); ++lane)
          partners[lane] = &elements_[queue[std::min(lane, queue.size() - 1)]];
        far_.integrate(elements_[m], partners, tiers / far_.n_tiers(), tiers % far_.n_tiers());
        for (std::size_t lane = 0; lane < queue.size(); ++lane)
        {
          far_.copy(lane, integrals_);
          if (collinear(elements_[m], *partners[lane], round_off_))
          {
            integrals_.double_layer.setZero();
            integrals_.reversed.setZero();
          }
          matrices_.set(m, queue[lane], integrals_);
        }
        queue.clear();
      }

      const std::vector<BoundaryElement> &elements_;
      NearPairs near_;
      FarPairs far_;
      std::vector<std::vector<std::size_t>> queues_; // far from one element, by both tiers
      PairIntegrals integrals_;
      KernelMatrices matrices_;
      double round_off_;
    };
  } // namespace

  KernelMatrices::KernelMatrices(const std::vector<BoundaryElement> &elements, const unsigned int degree)
      : degree(degree), lengths(static_cast<Eigen::Index>(elements.size()))
  {
    for (std::size_t m = 0; m < elements.size(); ++m)
      lengths[static_cast<Eigen::Index>(m)] = elements[m].length;
    const Eigen::Index n = lengths.size() * (degree + 1);
    for (Eigen::MatrixXd *matrix : {&log, &even_real, &even_imag, &double_layer})
      *matrix = large_matrix(n, n);
  }

  void KernelMatrices::set(const std::size_t first, const std::size_t second, const PairIntegrals &integrals)
  {
    AssertIndexRange(static_cast<Eigen::Index>(first), lengths.size());
    AssertIndexRange(static_cast<Eigen::Index>(second), lengths.size());
    const Eigen::Index size = degree + 1, row = static_cast<Eigen::Index>(first) * size,
                       column = static_cast<Eigen::Index>(second) * size;
    for (Eigen::Index j = 0; j < size; ++j)
      for (Eigen::Index i = 0; i < size; ++i)
      {
        log(row + i, column + j) = log(column + j, row + i) = integrals.log(i, j);
        even_real(row + i, column + j) = even_real(column + j, row + i) = integrals.even_real(i, j);
        even_imag(row + i, column + j) = even_imag(column + j, row + i) = integrals.even_imag(i, j);
        double_layer(row + i, column + j) = integrals.double_layer(i, j);
        double_layer(column + j, row + i) = integrals.reversed(i, j);
      }
  }

  KernelMatrices kernel_matrices(const std::vector<BoundaryElement> &elements, const unsigned int degree,
                                 const GalerkinRule &rule)
  {
    Assert(degree <= max_density_degree, dealii::ExcMessage("no such polynomials"));
    Assert(std::all_of(elements.begin(), elements.end(),
                       [](const BoundaryElement &element) { return element.length > 0.; }),
           dealii::ExcMessage("elements have a length"));
    return KernelFiller(elements, degree, rule).fill();
  }
} // namespace abut
