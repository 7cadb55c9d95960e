// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/page/pass_drawings.h>
#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /// What the page tells beside the results.
  struct PageContext
  {
    const std::vector<PassDrawing> &drawings;
    const std::vector<std::string> &left_out; ///< of the files
    double output_seconds;                    ///< of the files written before
    double total_seconds;                     ///< up to now
  };

  /**
   * The content of report.html: one page with what a run has found, in pictures, curves and tables. It needs
   * no other file, no network and no script (the script steps through the passes' pictures) and stays below
   * 3 MB: see PassDrawings, `write_cell_paths`, `thinned` and `write_table` for what is left out of large
   * runs.
   */
  std::string report_page(const Results &results, const PageContext &context);
} // namespace abut
