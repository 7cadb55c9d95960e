// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/reference/csv_files.h>

namespace abut
{
  /// The fields of the VTU files, described as columns are; the bodies give them their names.
  const std::vector<CsvColumn> &vtu_fields();
} // namespace abut
