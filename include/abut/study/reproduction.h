// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace abut
{
  /**
   * Runs a scene and the variants of its section `Study`, prints what they came to, and writes figures (SVG)
   * and their data (CSV) into the output directory: for a scene with the combined algorithm those of the
   * paper's numerical example (see `write_paper_figures`), for another one error against unknowns and
   * seconds. Returns whether the scene itself reached what it was asked for; variants need not. Throws
   * UserError and ComputationError.
   */
  bool run_reproduction(const std::string &file, const std::vector<std::string> &overrides, bool quiet,
                        std::ostream &out);
} // namespace abut
