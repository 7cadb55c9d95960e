// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  struct ObservedRun;
  struct Scene;

  /// Into the folder of results: errors.svg and errors.csv, the true errors of every pass against unknowns
  /// and seconds. Returns a table for each run. All passes know their true errors of stress and energy.
  /// Throws UserError.
  std::string write_error_figures(const Scene &scene, const std::vector<ObservedRun> &runs);
} // namespace abut
