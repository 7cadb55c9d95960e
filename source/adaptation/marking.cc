// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut
{
  namespace
  {
    using Index = Eigen::Index;

    constexpr double round_off = 1e-9; // eta

    /// Cells by falling error; equal ones by index, so that the order is the same everywhere.
    std::vector<std::size_t> by_falling_error(const Eigen::VectorXd &errors)
    {
      std::vector<std::size_t> cells(static_cast<std::size_t>(errors.size()));
      std::iota(cells.begin(), cells.end(), std::size_t(0));
      std::stable_sort(cells.begin(), cells.end(), [&](const std::size_t a, const std::size_t b) {
        return errors[static_cast<Index>(a)] > errors[static_cast<Index>(b)];
      });
      return cells;
    }

    /// Moves the end of the first n cells behind those whose errors equal, within 1e-6, that of the n-th.
    std::size_t with_equal_ones(const Eigen::VectorXd &errors, const std::vector<std::size_t> &cells,
                                std::size_t n)
    {
      if (n == 0)
        return 0;
      const double least = (1. - 1e-6) * errors[static_cast<Index>(cells[n - 1])];
      while (n < cells.size() && errors[static_cast<Index>(cells[n])] >= least)
        ++n;
      return n;
    }

    /// How many of the first cells carry the share of the squared error.
    std::size_t cells_that_carry(const Eigen::VectorXd &errors, const std::vector<std::size_t> &cells,
                                 const double share)
    {
      const double goal = share * errors.squaredNorm();
      double sum = 0.;
      std::size_t n = 0;
      while (n < cells.size() && sum < goal)
      {
        const double error = errors[static_cast<Index>(cells[n++])];
        sum += error * error;
      }
      return n;
    }

    std::size_t share_of(const std::size_t n, const double share)
    {
      return static_cast<std::size_t>(std::ceil(share * static_cast<double>(n) - 1e-9));
    }
  } // namespace

  CellMarks mark(const CellErrors &errors, const Eigen::VectorXd &eta, const AdaptationParameters &parameters)
  {
    const auto n = static_cast<std::size_t>(eta.size());
    const std::vector<std::size_t> cells = by_falling_error(errors.stress);
    std::size_t n_split = 0, n_kept = n; // of the first; behind those kept, cells may be merged
    CellMarks marks{std::vector<bool>(n, false), std::vector<bool>(n, false)};
    switch (parameters.marking)
    {
    case Marking::threshold:
      for (std::size_t i = 0; i < n; ++i)
      {
        const double error = eta[static_cast<Index>(i)];
        marks.refine[i] = error > std::max(parameters.limit, round_off);
        marks.coarsen[i] = error < parameters.coarsening * parameters.limit;
      }
      return marks;
    case Marking::fixed_fraction:
      n_split = share_of(n, parameters.fraction);
      n_kept = n - share_of(n, parameters.coarsening);
      break;
    case Marking::doerfler:
      n_split = cells_that_carry(errors.stress, cells, parameters.fraction);
      if (parameters.coarsening > 0.)
        n_kept = cells_that_carry(errors.stress, cells, 1. - parameters.coarsening);
      break;
    }
    n_split = with_equal_ones(errors.stress, cells, n_split);
    n_kept = with_equal_ones(errors.stress, cells, std::max(n_split, n_kept));
    for (std::size_t i = 0; i < n_split; ++i)
      marks.refine[cells[i]] = eta[static_cast<Index>(cells[i])] > round_off;
    for (std::size_t i = n_kept; i < n; ++i)
      marks.coarsen[cells[i]] = true;
    return marks;
  }
} // namespace abut
