// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace abut
{
  struct Arguments;

  /// A word of the command line that does something else with a file than solving it.
  struct Subcommand
  {
    std::string name;
    std::string documentation; ///< for `--help`
    /// Does it and returns the exit status. May throw UserError and ComputationError.
    std::function<int(const Arguments &arguments, std::ostream &out, std::ostream &err)> run;
  };

  /// What the command line says.
  struct Arguments
  {
    std::string file;                   ///< empty with print_parameters only
    std::vector<std::string> overrides; ///< `Section/Name=value`, in their order; `--output` last
    bool check = false, quiet = false, print_parameters = false;
    const Subcommand *subcommand = nullptr; ///< null: solve the file
  };

  /// Reads the command line. Empty where it is dealt with, `--help` and mistakes: `status` is then what to
  /// end with. `subcommands` must outlive the result.
  std::optional<Arguments> parse_arguments(int argc, const char *const *argv,
                                           const std::vector<Subcommand> &subcommands, int &status,
                                           std::ostream &out, std::ostream &err);
} // namespace abut
