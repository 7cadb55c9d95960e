// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/study_run.h>

#include <map>
#include <string>
#include <vector>

namespace abut
{
  /// A quantity of a diagram's axis.
  struct StudyAxis
  {
    std::string name;  ///< of the values in StudyLine
    std::string label; ///< for people
  };

  /// What errors stand against: unknowns, seconds.
  const std::vector<StudyAxis> &study_costs();

  /// One line of a diagram, a variant's or another program's: what is known at each of its points, by the
  /// axes' names.
  struct StudyLine
  {
    std::string program; ///< empty: this one
    std::string name;
    std::vector<std::map<std::string, double>> points;

    std::string title() const { return program.empty() ? name : program + ": " + name; }
    /// Minus the slope of the straight line through the points in double logarithmic scale, least squares;
    /// not a number where fewer than two costs are known.
    double order(const std::string &error, const std::string &cost) const;
  };

  /// Of the variants, then those of other programs. Values that are not above 0 have no place on logarithmic
  /// axes and are left out.
  std::vector<StudyLine> study_lines(const std::vector<StudyRun> &runs, const std::vector<StudyLine> &peers);

  /// The errors that some line knows: stress, energy, pressure, force, ...
  std::vector<StudyAxis> known_errors(const std::vector<StudyLine> &lines);

  /**
   * The points of other programs for a scene, from the CSV file `Study/Peers`: a line for each program and
   * variant. Seconds are those without the program's start where the file tells them, as this program's are.
   * Empty where no file is named. Throws UserError with file and line.
   */
  std::vector<StudyLine> read_peers(const Scene &scene);
} // namespace abut
