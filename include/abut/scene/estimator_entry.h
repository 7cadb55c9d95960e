// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/registry.h>

#include <memory>

namespace abut
{
  class Indicator;
  struct AdaptationParameters;

  /**
   * The range of estimated by true error, energy norm, that an estimator has had with elements of a degree on
   * scenes with exact solutions: layers in contact, sliding and bonded, flat punch, re-entrant corner
   * (tests/convergence/estimator_worth.cc measures it).
   */
  struct EstimatorWorth
  {
    double least, most;
    /// More than twice too small or too large.
    bool is_rough() const { return least < .5 || most > 2.; }
  };

  /// What stands behind a word of `Estimator`. Each estimator has its own in source/adaptation/.
  struct EstimatorEntry
  {
    static constexpr const char *parameter = "Estimator";

    std::string name, documentation;
    /// Null: nothing is estimated.
    std::unique_ptr<Indicator> (*make)(const AdaptationParameters &parameters) = nullptr;
    /// Of `automatic`: what estimates again where the goal is near. Null for the others.
    std::unique_ptr<Indicator> (*make_certifier)(const AdaptationParameters &parameters) = nullptr;
    std::vector<EstimatorWorth> worth = {}; ///< for degrees 1, 2, ...; fewer where it is not known
    /// Boundary elements answer the same data: their stress is in balance, which bounds the error.
    bool has_boundary_elements = false;
    /// Of each process it asks for no more than its own cells and those around them.
    bool takes_distributed_meshes = false;

    bool estimates() const { return make != nullptr; }
    /// Null where it is not known.
    const EstimatorWorth *worth_at(const unsigned int degree) const
    {
      return degree <= worth.size() ? &worth[degree - 1] : nullptr;
    }
  };
} // namespace abut
