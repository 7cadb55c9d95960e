// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>

namespace abut
{
  /// Exit statuses of the program.
  enum ExitStatus
  {
    converged = 0,
    wrong_input = 1,  ///< command line, parameter, mesh or scene; nothing was written
    not_converged = 2 ///< ran, but did not reach what it was asked for
  };

  /**
   * The whole program: reads the command line, runs what it asks for and returns the exit status. Tables and
   * progress go to `out`, messages of errors, one sentence each, to `err`.
   */
  int run_command_line(int argc, const char *const *argv, std::ostream &out, std::ostream &err);
} // namespace abut

/// The same with the standard streams, for who opens the library at run time: the launcher.
extern "C" int abut_run_command_line(int argc, const char *const *argv);
