// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/adaptation/marking.h>

#include <cmath>

namespace abut
{
  namespace
  {
    std::size_t number_of(const std::size_t n, const double share)
    {
      return static_cast<std::size_t>(std::ceil(share * static_cast<double>(n) - 1e-9));
    }

    CellMarks mark_fraction(const CellErrors &errors, const Eigen::VectorXd &eta,
                            const AdaptationParameters &parameters)
    {
      const auto n = static_cast<std::size_t>(eta.size());
      return split_first(errors, eta, number_of(n, parameters.fraction),
                         n - number_of(n, parameters.coarsening));
    }

    const Registered<MarkingEntry> registered_fixed_fraction(
        {"fixed fraction",
         "the share Fraction of the cells, those with the largest errors; the share Coarsening of them, "
         "with the smallest, may be merged",
         mark_fraction});
  } // namespace
} // namespace abut
