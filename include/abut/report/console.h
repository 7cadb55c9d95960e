// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <iosfwd>
#include <string>

namespace abut
{
  /// What the user should know, a line each.
  void print_warnings(std::ostream &out, const std::vector<Warning> &warnings);

  /// The tables that end a run: bodies, contacts, forces, how the iteration stopped and what its result is
  /// worth, times, what was left out, and where the files are.
  void print_results(std::ostream &out, const Results &results, const std::string &directory,
                     double total_seconds);
} // namespace abut
