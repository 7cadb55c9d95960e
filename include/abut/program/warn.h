// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/run/checks/validity.h>

#include <iosfwd>
#include <string>

namespace abut
{
  /// A line for each warning, which names the parameter file.
  void warn(std::ostream &err, const std::string &file, const Warnings &warnings);

  /// The same, and again among the results, unless these are quiet or one reader has both streams.
  void warn_with_results(std::ostream &out, std::ostream &err, const std::string &file, bool quiet,
                         const Warnings &warnings);
} // namespace abut
