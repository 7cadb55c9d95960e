// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/observed_run.h>

#include <string>
#include <vector>

namespace abut
{
  /// The runs that the paper's figures are made of.
  struct PaperRuns
  {
    ObservedRun base;                  ///< the scene itself
    std::vector<ObservedRun> variants; ///< those of its section Study
  };

  /// Where the cells lie that were split most often.
  struct Refinement
  {
    unsigned int finest = 0; ///< level
    double distance = 0.;    ///< mean of their centres' distances from the contact zone
    double all = 0.;         ///< the same for the whole body, mean over its area
  };

  /// The mean of the corners.
  Vector2 cell_centre(const Polyline &cell);

  /// `half_width`: of the contact zone, which begins at x = 0 on the top of the body.
  Refinement refinement(const ObservedPass &pass, double half_width);

  /// Unknowns of finite and boundary elements on the mesh of equal cells as small as the smallest one; the
  /// boundary elements counted with as many unknowns for each as on the mesh itself.
  std::size_t unknowns_of_uniform_mesh(const ObservedPass &pass, const BodyDescription &body);

  /**
   * Into the folder: figure04 (von Mises stress), figure07 (initial, third, last mesh), figure08
   * (displacement at a point against delta), figure09 (contact displacement and pressure by pass, with
   * infinite layers without penalty), figure10 (unknowns against 1/delta), each as .svg and .csv. Runs for
   * the curves against delta are the variants named by a number; a variant named `limit` is drawn as their
   * limit. The scene must name infinite sliding layers as its exact solution. Throws UserError. Returns lines
   * of text with the numbers that the figures show.
   */
  std::string write_paper_figures(const Scene &scene, const PaperRuns &runs);

  /// A table of all runs, and the same as passes.csv in the folder of results.
  std::string write_run_table(const Scene &scene, const PaperRuns &runs);

  /// The half-width of contact between infinite layers without penalty, by the scene's data.
  double exact_half_width(const Scene &scene);
} // namespace abut
