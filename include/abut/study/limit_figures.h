// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  struct PaperRuns;
  struct Scene;

  /**
   * Into the folder of results: figure08 (displacement at a point against delta, beside that of the run that
   * iterates to the limit) and figure10 (unknowns against 1/delta), each as .svg and .csv; nothing where no
   * run is a point of them (PaperRuns::by_limit). Returns the table of both, empty without points. Throws
   * UserError.
   */
  std::string write_limit_figures(const Scene &scene, const PaperRuns &runs);
} // namespace abut
