// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>

namespace abut
{
  namespace
  {
    /// How many of the first cells carry the share of the squared error [Doerfler1996].
    std::size_t cells_that_carry(const Eigen::VectorXd &errors, const std::vector<std::size_t> &cells,
                                 const double share)
    {
      const double goal = share * errors.squaredNorm();
      double sum = 0.;
      std::size_t n = 0;
      while (n < cells.size() && sum < goal)
      {
        const double error = errors[static_cast<Eigen::Index>(cells[n++])];
        sum += error * error;
      }
      return n;
    }

    CellMarks mark_by_share_of_error(const CellErrors &errors, const Eigen::VectorXd &eta,
                                     const AdaptationParameters &parameters)
    {
      const std::vector<std::size_t> cells = by_falling_error(errors.stress);
      const std::size_t n_split = cells_that_carry(errors.stress, cells, parameters.fraction);
      const std::size_t n_kept = parameters.coarsening > 0.
                                     ? cells_that_carry(errors.stress, cells, 1. - parameters.coarsening)
                                     : cells.size();
      return split_first(errors, eta, n_split, n_kept);
    }

    const Registered<MarkingEntry> registered_doerfler(
        {"doerfler",
         "the fewest cells that carry the share Fraction of the squared error; as many as carry the share "
         "Coarsening of it, with the smallest errors, may be merged",
         mark_by_share_of_error});
  } // namespace
} // namespace abut
