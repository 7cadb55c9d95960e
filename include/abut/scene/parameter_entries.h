// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/scene/parameter_sections.h>

#include <string>
#include <vector>

namespace abut
{
  /// A parameter as its owner declares it.
  struct ParameterEntry
  {
    std::string name, value; ///< value: the default
    std::string documentation;
    std::string pattern; ///< deal.II's description, `[Integer range 1...3 (inclusive)]`

    bool operator==(const ParameterEntry &other) const
    {
      return name == other.name && value == other.value && documentation == other.documentation &&
             pattern == other.pattern;
    }
  };

  /// Those of a section, in the order of declaration.
  std::vector<ParameterEntry> parameter_entries(const SectionDeclaration &section);
} // namespace abut
