// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_lines.h>

namespace abut
{
  /// A parameter file and the overrides that follow it.
  class ParameterFile
  {
  public:
    /// Throws UserError for a file that cannot be read, and for an override that is not
    /// `Section/Sub/Name=value`.
    ParameterFile(const std::string &name, const std::vector<std::string> &overrides);

    /// Those of the file, read_parameter_lines.
    std::vector<ParameterLine> lines() const { return read_parameter_lines(text_); }
    const std::vector<ParameterLine> &overrides() const { return overrides_; }

    const std::string &name() const { return name_; }
    /// Where relative names in the file begin.
    std::string directory() const;

  private:
    std::string name_;
    std::string text_;
    std::vector<ParameterLine> overrides_;
  };
} // namespace abut
