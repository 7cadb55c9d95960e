// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// Whether the words of a parameter are registered (Vocabulary).
  bool has_vocabulary(const std::string &entry);

  /// doc/reference/parameters.md: every parameter of every section.
  std::string parameter_page();
} // namespace abut
