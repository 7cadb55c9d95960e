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

  /// The same, and a machine that goes down keeps the old content or the new one: it is on the disk before
  /// the old one goes. Costs as long as the disk takes.
  void write_file_to_disk(const std::string &path, const std::string &content);

  /**
   * The folder of a run's results, for this run alone as long as the object lives. Construction makes it and
   * those above it where they are missing, and removes what a killed run has left of files that it was
   * writing. Throws UserError where the path is a file, nothing can be written there, or another run writes
   * there at this moment (on file systems that can lock a folder).
   */
  class OutputDirectory
  {
  public:
    explicit OutputDirectory(const std::string &path);
    ~OutputDirectory();
    OutputDirectory(const OutputDirectory &) = delete;
    OutputDirectory &operator=(const OutputDirectory &) = delete;

  private:
    int descriptor_; ///< open as long as the folder is locked
  };
} // namespace abut
