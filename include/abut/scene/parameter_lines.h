// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/archive.h>

#include <string>
#include <vector>

namespace abut
{
  /// A line of a parameter file that enters a section or sets an entry. In names, white space is one blank.
  struct ParameterLine
  {
    std::vector<std::string> sections; ///< in which it stands or which it enters, from the outermost
    bool sets = false;                 ///< an entry; else it enters the last of `sections`
    std::string name = {}, value = {}; ///< of the entry
    unsigned int number = 0;           ///< of the line, from 1; 0 in included files and for overrides
    std::string place = {};            ///< how a message on it begins: "line 7: "

    /// The sections, joined by `/`.
    std::string section() const;

    void serialize(Archive &archive) { archive(sections, sets, name, value, number, place); }
  };

  /**
   * Reads the text of a parameter file as deal.II's ParameterHandler does: comments from `#` on, lines that
   * end in a backslash go on in the next one, `include` reads a file by its name for the working directory.
   * What the names mean is for others to say. Throws UserError, which names the line, but not the file unless
   * it is an included one.
   */
  std::vector<ParameterLine> read_parameter_lines(const std::string &text);

  /// A whole file. Line ends may be those of any system. Throws UserError where it cannot be read.
  std::string read_parameter_text(const std::string &name);
} // namespace abut
