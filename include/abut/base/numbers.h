// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /// For files of numbers: 17 significant digits, so that reading gives back the same number. Empty where it
  /// is not finite.
  std::string exact_number(double value);

  /// For people: the given number of significant digits, "-" where it is not finite.
  std::string short_number(double value, int digits = 4);

  /**
   * Rows of a table in columns two spaces apart, a line each: the first column flush left, the others flush
   * right. Rows may differ in length.
   */
  std::string aligned(const std::vector<std::vector<std::string>> &rows);
} // namespace abut
