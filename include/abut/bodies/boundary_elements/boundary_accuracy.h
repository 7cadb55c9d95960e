// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace abut
{
  /// When boundary elements are computed fast, by expansions and iteration in place of all pairs, and how
  /// accurately.
  struct BoundaryAccuracy
  {
    double share = 1e-3; ///< error, as a share of what is estimated; 0: always all pairs
    // From so many on the fast way is faster, see doc/estimator.md.
    std::size_t least_elements = 100;        ///< of the stress inside
    std::size_t least_solved_elements = 165; ///< of the solution

    bool evaluates_fast(const std::size_t n_elements) const
    {
      return share > 0. && n_elements >= least_elements;
    }
    bool solves_fast(const std::size_t n_elements) const
    {
      return share > 0. && n_elements >= least_solved_elements;
    }
    /// Of the stress, relative, for an estimated error of it; not below what round-off leaves.
    double tolerance(const double estimated_error) const { return std::max(1e-11, share * estimated_error); }
  };
} // namespace abut
