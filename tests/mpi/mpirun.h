// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../regression/program.h"

namespace abut::testing
{
  /// What processes with the same arguments are told.
  struct Group
  {
    unsigned int n_processes;
    std::vector<std::string> arguments;
  };

  /// Runs the program in all processes of the groups, ranks in their order, with `--output` set to a new
  /// folder. mpirun's own words are left out of `err`. A run that hangs ends with status 124.
  Answer run_processes(const std::vector<Group> &groups);

  /// The same with a folder of the caller's.
  Answer run_processes_in(const std::string &directory, const std::vector<Group> &groups);

  /// The same without `--output`.
  Answer run_processes_with(const std::vector<Group> &groups);

  /// The lines of a text.
  std::vector<std::string> lines(const std::string &text);
} // namespace abut::testing
