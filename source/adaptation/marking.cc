// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>

#include <algorithm>
#include <numeric>

namespace abut
{
  /// Cells by falling error; equal ones by index, so that the order is the same everywhere.
  std::vector<std::size_t> by_falling_error(const Eigen::VectorXd &errors)
  {
    std::vector<std::size_t> cells(static_cast<std::size_t>(errors.size()));
    std::iota(cells.begin(), cells.end(), std::size_t(0));
    std::stable_sort(cells.begin(), cells.end(), [&](const std::size_t a, const std::size_t b) {
      return errors[static_cast<Eigen::Index>(a)] > errors[static_cast<Eigen::Index>(b)];
    });
    return cells;
  }

  namespace
  {
    /// Moves the end of the first n cells behind those whose errors equal, within 1e-6, that of the n-th.
    std::size_t with_equal_ones(const Eigen::VectorXd &errors, const std::vector<std::size_t> &cells,
                                std::size_t n)
    {
      if (n == 0)
        return 0;
      const double least = (1. - 1e-6) * errors[static_cast<Eigen::Index>(cells[n - 1])];
      while (n < cells.size() && errors[static_cast<Eigen::Index>(cells[n])] >= least)
        ++n;
      return n;
    }
  } // namespace

  CellMarks split_first(const CellErrors &errors, const Eigen::VectorXd &eta, std::size_t n_split,
                        std::size_t n_kept)
  {
    AssertDimension(eta.size(), errors.stress.size());
    const std::vector<std::size_t> cells = by_falling_error(errors.stress);
    Assert(n_split <= cells.size() && n_kept <= cells.size(), dealii::ExcMessage("shares of all cells"));
    n_split = with_equal_ones(errors.stress, cells, n_split);
    n_kept = with_equal_ones(errors.stress, cells, std::max(n_split, n_kept));
    CellMarks marks = no_marks(cells.size());
    for (std::size_t i = 0; i < n_split; ++i)
      marks.refine[cells[i]] = eta[static_cast<Eigen::Index>(cells[i])] > round_off_eta;
    for (std::size_t i = n_kept; i < cells.size(); ++i)
      marks.coarsen[cells[i]] = true;
    return marks;
  }

  namespace
  {
    MarkingEntry automatic_marking_entry()
    {
      MarkingEntry entry{"automatic",
                         "with a Tolerance: the fewest cells of all bodies together that bring the "
                         "error below it, but no more than carry nine tenths of its square"};
      entry.needs_tolerance = true;
      return entry;
    }

    const Registered<MarkingEntry> registered_automatic_marking(automatic_marking_entry());
  } // namespace

  CellMarks mark(const CellErrors &errors, const Eigen::VectorXd &eta, const AdaptationParameters &parameters)
  {
    return Registry<MarkingEntry>::get().find(parameters.marking).mark(errors, eta, parameters);
  }
} // namespace abut
