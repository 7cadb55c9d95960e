// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/report/history.h>
#include <abut/report/page/pass_drawings.h>
#include <abut/results/results.h>

#include <string>
#include <vector>

namespace abut
{
  /// What `write_all` can tell only afterwards.
  struct Written
  {
    double seconds = 0.;
    std::vector<std::string> left_out; ///< files that were not written, and why
  };

  /// Removes an earlier run's summary, page and picture: they would speak for a run that ends without
  /// results.
  void remove_old_results(const std::string &directory);

  /**
   * Writes all files of a run into an existing folder (see OutputDirectory), each whole or not at
   * all. An old summary.json goes first and the new one comes last: where it is, the rest is complete and
   * belongs to it. It counts the time of the writing to that of the results and to `total_seconds`. All
   * processes of the executor have to call it: each writes the fields of the bodies that live in it, the
   * first one the rest. Throws UserError.
   */
  Written write_all(const Results &results, const History &history, PassDrawings drawings,
                    const std::string &directory, double total_seconds, const Executor &executor = {});
} // namespace abut
