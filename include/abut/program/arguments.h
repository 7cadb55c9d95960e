// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /// What is to be done with the file; the words of the command line, `solve` is the one without a word.
  enum class Task
  {
    solve,
    study,
    schemes,
    reproduce
  };

  /// What the command line says.
  struct Arguments
  {
    std::string file;                   ///< empty with resume, print_parameters and reference only
    std::string resume;                 ///< folder of the run to go on with; empty: none
    std::vector<std::string> overrides; ///< `Section/Name=value`, in their order; `--output` last
    std::string reference;              ///< name of the page to print; empty: none
    bool check = false, quiet = false, print_parameters = false;
    Task task = Task::solve; ///< of several words the one that `--help` lists first
  };

  /// Reads the command line. Empty where it is dealt with, `--help` and mistakes: `status` is then what to
  /// end with. Needs nothing else of the program: the launcher answers by it before it loads the rest.
  std::optional<Arguments> parse_arguments(int argc, const char *const *argv, int &status, std::ostream &out,
                                           std::ostream &err);
} // namespace abut
