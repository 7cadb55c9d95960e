// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace abut::testing
{
  /// The files of a folder, by name.
  std::map<std::string, std::string> files_in(const std::string &folder);

  /// All files of a run have the same content as those of another one, but for seconds, memory, counters of
  /// what was computed, and the name of the folder.
  void expect_same_results(const std::string &found, const std::string &expected);
} // namespace abut::testing
