// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  struct PaperRuns;
  struct Scene;

  /// A table of all runs, and the same pass by pass as passes.csv in the folder of results. `half_width`: of
  /// the contact zone, see `refinement`. Throws UserError.
  std::string write_run_table(const Scene &scene, const PaperRuns &runs, double half_width);
} // namespace abut
