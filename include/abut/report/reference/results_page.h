// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace abut
{
  /// doc/reference/results.md: every key of summary.json and every column of the CSV files.
  std::string results_page();
} // namespace abut
