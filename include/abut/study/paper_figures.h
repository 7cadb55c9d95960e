// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  struct PaperRuns;
  struct Scene;
  class PressedLayers;

  /**
   * The figures of the paper's numerical example and their data, into the folder of results: those of
   * `write_mesh_figures`, `write_iteration_figures` and `write_limit_figures`. `exact`: infinite sliding
   * layers without penalty. Throws UserError. Returns lines of text with the numbers that the figures show.
   */
  std::string write_paper_figures(const Scene &scene, const PaperRuns &runs, const PressedLayers &exact);
} // namespace abut
