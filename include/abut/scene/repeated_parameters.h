// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_lines.h>

namespace abut
{
  /// A parameter that a file sets more than once: the last line counts.
  struct RepeatedParameter
  {
    std::string name; ///< with its sections: "Body steel/Size"
    unsigned int first_line = 0, last_line = 0;
  };

  /// Those of a parameter file itself, without what it includes, each once. Sections may be entered more than
  /// once.
  std::vector<RepeatedParameter> repeated_parameters(const std::vector<ParameterLine> &lines);
} // namespace abut
