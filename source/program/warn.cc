// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/program/warn.h>
#include <abut/report/console.h>

#include <iostream>
#include <sys/stat.h>
#include <unistd.h>

namespace abut
{
  namespace
  {
    /// Whether both are read in one place: a terminal, a file.
    bool share_a_reader(const std::ostream &out, const std::ostream &err)
    {
      struct stat of_out, of_err;
      return &out == &std::cout && &err == &std::cerr && fstat(STDOUT_FILENO, &of_out) == 0 &&
             fstat(STDERR_FILENO, &of_err) == 0 && of_out.st_dev == of_err.st_dev &&
             of_out.st_ino == of_err.st_ino;
    }
  } // namespace

  void warn(std::ostream &err, const std::string &file, const Warnings &warnings)
  {
    for (const Warning &warning : warnings)
      err << "abut: " << file << ": warning (" << to_string(warning.code) << "): " << warning.text << '\n';
  }

  void warn_with_results(std::ostream &out, std::ostream &err, const std::string &file, const bool quiet,
                         const Warnings &warnings)
  {
    warn(err, file, warnings);
    if (!quiet && !share_a_reader(out, err))
      print_warnings(out, warnings);
  }
} // namespace abut
