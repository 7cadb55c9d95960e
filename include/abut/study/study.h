// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace abut
{
  /**
   * Runs the variants that the section `Study` of a file lists, one after the other, prints error against
   * unknowns and against seconds for every pass of each and, where the exact response is known, what the
   * estimator is worth; writes the same to study.csv in the output directory. Throws UserError, also for a
   * file without variants. Returns the names of those that did not reach what they were asked for.
   */
  std::vector<std::string> run_study(const std::string &file, const std::vector<std::string> &overrides,
                                     bool quiet, std::ostream &out);
} // namespace abut
