// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_data.h>
#include <abut/study/study_lines.h>

namespace abut
{
  /**
   * The content of study.html, a page that needs no other file: a diagram of error against cost with controls
   * (uPlot), figures in its place where there are no scripts, the table, and the data for programs: JSON in
   * the element `study-data`, whose `columns` and `rows` are those of study.csv, null where nothing is known.
   */
  std::string study_page(const Scene &scene, const StudyData &data, const std::vector<StudyLine> &lines);
} // namespace abut
