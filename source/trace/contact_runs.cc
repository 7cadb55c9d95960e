// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/trace/contact_runs.h>

namespace abut
{
  std::vector<ContactRun> contact_runs(const Stretch &stretch,
                                       const std::function<bool(std::size_t part)> &presses)
  {
    const std::size_t n = stretch.last - stretch.first;
    std::size_t begin = 0; // a closed stretch begins with a part that does not press
    while (stretch.closed && begin < n && presses(stretch.first + begin))
      ++begin;
    std::vector<ContactRun> runs;
    bool goes_on = false;
    for (std::size_t i = begin; i < begin + n; ++i)
    {
      const std::size_t part = stretch.first + i % n;
      const bool presses_here = presses(part);
      if (presses_here && !goes_on)
        runs.emplace_back();
      if (presses_here)
        runs.back().push_back(part);
      goes_on = presses_here;
    }
    return runs;
  }
} // namespace abut
