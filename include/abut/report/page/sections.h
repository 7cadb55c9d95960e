// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/results.h>

#include <iosfwd>

namespace abut
{
  // Parts of report.html, in the order of the page.

  /// Name, status, one sentence, and the warnings.
  void write_head(std::ostream &out, const Results &results);
  /// A section of its own, nothing where there are none. Pages of studies have it too.
  void write_warnings(std::ostream &out, const std::vector<Warning> &warnings);
  /// Tables of contacts, of bodies and of what the error is made of.
  void write_key_figures(std::ostream &out, const Results &results);
  /// Pressure and gap along each pair: of many pairs those with the largest forces.
  void write_interfaces(std::ostream &out, const Results &results);
  /// The parts of the error pass by pass, and the table of passes.
  void write_errors(std::ostream &out, const Results &results);
  /// `total_seconds`: up to the writing of the page.
  void write_times(std::ostream &out, const Times &times, double total_seconds);
  void write_left_out(std::ostream &out, const std::vector<std::string> &items);
} // namespace abut
