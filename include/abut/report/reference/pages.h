// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// A file of doc/reference, which the program prints.
  struct ReferencePage
  {
    std::string name; ///< for the command line
    std::string file;
    std::string (*text)();
  };

  const std::vector<ReferencePage> &reference_pages();
} // namespace abut
