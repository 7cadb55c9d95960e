// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace abut
{
  /**
   * A key of summary.json as the reference describes it. Every key is always there; what was not estimated or
   * does not apply is null.
   */
  struct SummaryKey
  {
    /// From the top, `contacts[].force`; `[]`: of every entry of a list, `<side>`: whatever the name is.
    /// Objects and lists come before what is in them.
    std::string path;
    /// text, texts, true or false, count, number, vector (two numbers), object, list (of objects), or
    /// `one of: a | b`; each with ` or null`.
    std::string type;
    std::string unit;    ///< of numbers; empty: counts and what is no number
    std::string meaning; ///< without its full stop
  };

  /// All of them: the one source of the schema and of the page.
  const std::vector<SummaryKey> &summary_keys();

  /// Those of `pass_table`.
  std::vector<SummaryKey> pass_keys();
} // namespace abut
