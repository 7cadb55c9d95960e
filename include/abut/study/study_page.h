// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_lines.h>

namespace abut
{
  /**
   * The content of study.html, a page that needs no other file: warnings; quantities of every variant,
   * against the number that a sweep changes in a diagram too; a diagram of error against cost where errors
   * are known; the table of all passes. Diagrams have controls (uPlot), and figures in their place where
   * there are no scripts. The data for programs are JSON in the element `study-data`, whose `columns` and
   * `rows` are those of study.csv, null where nothing is known. `peers`: lines of other programs.
   */
  std::string study_page(const Scene &scene, const std::vector<StudyRun> &runs,
                         const std::vector<StudyLine> &peers);
} // namespace abut
