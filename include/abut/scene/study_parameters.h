// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace abut
{
  /// What the section `Study` says: runs of one scene with other parameters.
  struct StudyParameters
  {
    struct Variant
    {
      std::string name;
      std::vector<std::string> overrides;  ///< `Section/Name=value`, in their order
      std::vector<std::string> parameters; ///< `Section/Name`: what it sets beside the common overrides
    };
    std::vector<Variant> variants; ///< crossed, with the common overrides before their own; may be empty

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static StudyParameters parse(dealii::ParameterHandler &prm);
  };
} // namespace abut
