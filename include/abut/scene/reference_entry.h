// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/registry.h>

#include <memory>

namespace abut
{
  class ExactSolution;
  struct Scene;

  /// A number above 0 that a solution needs: an entry of the section `Reference`, which several may share.
  struct ReferenceDatum
  {
    std::string entry;
    std::string documentation; ///< without its end, the unit
    std::string unit;
  };

  /// What stands behind a word of `Exact solution`. Each solution has its own in source/comparison/.
  struct ReferenceEntry
  {
    static constexpr const char *parameter = "Exact solution";

    std::string name, documentation;
    std::vector<ReferenceDatum> data = {};
    bool can_be_penalised = false; ///< known also for the contact law with the penalty of the scene's pair
    /// Throws UserError where the scene is not the solution's. Null: there is none.
    std::unique_ptr<ExactSolution> (*make)(const Scene &scene) = nullptr;
  };
} // namespace abut
