// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_lines.h>

namespace abut
{
  /// What a parameter file, the files that it includes and the overrides say: all that a scene is made of but
  /// its mesh files.
  struct SceneInput
  {
    std::string name;                     ///< of the file, for messages
    std::vector<ParameterLine> lines;     ///< of the file, read_parameter_lines
    std::vector<ParameterLine> overrides; ///< after them
    std::string working_directory;        ///< in which it was read

    /// Where relative names in the file begin, as seen from the present working directory.
    std::string directory() const;

    void serialize(Archive &archive) { archive(name, lines, overrides, working_directory); }
  };

  /// A parameter file and the overrides that follow it.
  class ParameterFile
  {
  public:
    /// Throws UserError for a file that cannot be read, and for an override that is not
    /// `Section/Sub/Name=value`.
    ParameterFile(const std::string &name, const std::vector<std::string> &overrides);

    /// Throws UserError as read_parameter_lines does.
    SceneInput read() const;

  private:
    std::string name_;
    std::string text_;
    std::vector<ParameterLine> overrides_;
  };
} // namespace abut
