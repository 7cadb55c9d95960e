// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
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
      std::string load_case;               ///< empty: there are none
      std::vector<std::pair<std::string, std::string>> swept; ///< `Section/Name` and its value
    };
    std::vector<Variant> variants; ///< crossed, with the common overrides before their own; may be empty

    bool has_fine_run =
        false; ///< errors are those against a finer run of its own, where no solution is named
    std::vector<std::string> fine_run; ///< overrides of that run
    std::string peers;                 ///< a file with points of other programs; empty: none

    static void declare(dealii::ParameterHandler &prm);
    /// Reads the section the handler stands in. Throws UserError.
    static StudyParameters parse(dealii::ParameterHandler &prm);
  };
} // namespace abut
