// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace abut
{
  /**
   * The one number in which texts differ, of each of them: 1e-3 and 2e-3 of `1e-3, 4` and `2e-3, 4`; -0.1 and
   * -0.2 of `top: displacement y: -0.1` and `top: displacement y: -0.2`. Empty where they differ in several
   * numbers, in something else or not at all.
   */
  std::optional<std::vector<double>> number_that_differs(const std::vector<std::string> &texts);

  /// A text with a mark in the place of each number; digits within a name are none.
  std::string without_numbers(const std::string &text);
} // namespace abut
