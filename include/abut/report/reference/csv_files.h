// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// A column of a CSV file as the reference describes it.
  struct CsvColumn
  {
    std::string name;    ///< with `<pair>` and the like for what scenes name
    std::string unit;    ///< empty: texts and counts
    std::string meaning; ///< without its full stop
  };

  /// A CSV file that the program writes.
  struct CsvDescription
  {
    std::string name; ///< `contact_<pair>.csv`
    std::string rows; ///< who writes it, and what a row is
    std::vector<CsvColumn> columns;
  };

  /// Of runs: history.csv, contact_<pair>.csv.
  const std::vector<CsvDescription> &csv_files_of_runs();

  /// Of `abut study`, `abut schemes` and `abut reproduce`.
  const std::vector<CsvDescription> &csv_files_of_studies();

  /// The first line of a file, where it does not depend on the scene. Its writer and its description cannot
  /// have other columns.
  std::string csv_header(const std::string &file);
} // namespace abut
