// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /**
   * Writes a file whole or not at all: under a temporary name in the same folder, renamed when all of it is
   * there. A file that exists is replaced; on failure it stays as it was. Throws UserError with the path and
   * the system's reason.
   */
  void write_file(const std::string &path, const std::string &content);

  /// Makes the folder and those above it where they are missing. Throws UserError where the path is a file or
  /// nothing can be written there.
  void make_output_directory(const std::string &path);
} // namespace abut
