// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// What the reference says of a section of the parameter file.
  struct SectionNote
  {
    std::string section; ///< as declared: "Body <name>"; empty: outside all sections
    std::string meaning; ///< one sentence or two
  };

  /// What the reference says of a parameter beside its documentation and its pattern.
  struct ParameterNote
  {
    std::string section, entry;
    std::string unit;    ///< of its numbers, as its documentation says it; empty: they are none, or counts
    std::string allowed; ///< empty: what the pattern says
    std::string page;    ///< that explains it, with a heading, from doc/: "tolerance.md#what-is-chosen"
  };

  /// In the order of the reference.
  const std::vector<SectionNote> &section_notes();

  /// Null where there is none.
  const ParameterNote *find_note(const std::string &section, const std::string &entry);

  /// All of them. Each belongs to a parameter that is declared (a test compares).
  const std::vector<ParameterNote> &parameter_notes();
} // namespace abut
