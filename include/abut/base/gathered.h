// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/processes.h>

#include <algorithm>
#include <iterator>

namespace abut
{
  /// Everybody's values, those of one process after those of another; one's own where `processes` is null.
  /// All processes have to call it.
  template <typename T>
  std::vector<T> gathered(const std::shared_ptr<Processes> &processes, std::vector<T> own)
  {
    constexpr std::uint64_t gathering = 11; // a meeting
    if (!processes)
      return own;
    std::vector<T> all;
    for (std::vector<T> &values : processes->collect(gathering, [&]() { return std::move(own); }))
      all.insert(all.end(), std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
    return all;
  }

  /// Whether it holds in any process.
  inline bool in_any(const std::shared_ptr<Processes> &processes, const bool here)
  {
    const std::vector<char> all = gathered<char>(processes, {here ? char(1) : char(0)});
    return std::any_of(all.begin(), all.end(), [](const char there) { return there != 0; });
  }
} // namespace abut
