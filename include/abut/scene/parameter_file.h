// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/repeated_parameters.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// The text of a parameter file and the overrides that follow it. Line ends may be those of any system.
  class ParameterFile
  {
  public:
    /// Throws UserError for a file that cannot be read, and for an override that is not
    /// `Section/Sub/Name=value`.
    ParameterFile(const std::string &name, const std::vector<std::string> &overrides);

    /**
     * Sets the entries declared in `prm` from the file, then from the overrides in their order. Entries and
     * sections that are not declared are passed over where `skip_undefined`, else refused. Throws UserError,
     * which names the line or the override, but not the file.
     */
    void parse_into(dealii::ParameterHandler &prm, bool skip_undefined) const;

    /// What the file itself sets more than once; overrides are meant to.
    std::vector<RepeatedParameter> repeated() const { return repeated_parameters(text_); }

    const std::string &name() const { return name_; }
    /// Where relative names in the file begin.
    std::string directory() const;

  private:
    /// An override as it was given, and the same as lines of a parameter file.
    struct Override
    {
      std::string given;
      std::string lines;
    };

    std::string name_;
    std::string text_;
    std::vector<Override> overrides_;
  };
} // namespace abut
