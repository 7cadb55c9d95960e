// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>
#include <abut/run/setup.h>

namespace abut
{
  /// Why no further mesh is to be made after the last of the passes; empty where one is. The scene adapts,
  /// and the pass has converged.
  std::optional<AdaptationEnd> adaptation_end(const Setup &setup, const SchemeResult &iteration,
                                              const std::vector<PassRecord> &passes);

  /// The end where the marks of the last pass have changed no mesh.
  AdaptationEnd no_cell_to_split(const Setup &setup, const PassRecord &last);
} // namespace abut
