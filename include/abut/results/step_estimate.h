// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <optional>

namespace abut
{
  /// What boundary elements say of one step's displacement, in the energy norm, relative.
  struct StepEstimate
  {
    double discretisation;             ///< b of Estimation::bound
    std::optional<double> bound;       ///< discretisation and iteration together
    std::optional<double> true_error;  ///< against the exact solution that the scene names
    std::optional<double> ratio;       ///< b by the true error, both not relative
    std::optional<double> bound_ratio; ///< the bound by the true error

    void serialize(Archive &archive) { archive(discretisation, bound, true_error, ratio, bound_ratio); }
  };
} // namespace abut
