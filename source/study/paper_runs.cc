// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/study/paper_runs.h>

#include <algorithm>

namespace abut
{
  std::vector<const ObservedRun *> PaperRuns::all() const
  {
    std::vector<const ObservedRun *> runs = {&base};
    for (const ObservedRun &run : variants)
      runs.push_back(&run);
    return runs;
  }

  std::vector<const ObservedRun *> PaperRuns::by_limit() const
  {
    const std::vector<std::string> limit_alone = {"Adaptation/Limit"};
    std::vector<const ObservedRun *> runs;
    for (const ObservedRun &run : variants)
      if (run.parameters == limit_alone && run.converged)
        runs.push_back(&run);
    return runs;
  }

  const ObservedRun *PaperRuns::iterated() const
  {
    const auto run = std::find_if(variants.begin(), variants.end(),
                                  [](const ObservedRun &variant) { return !variant.adaptation.combined; });
    return run == variants.end() ? nullptr : &*run;
  }
} // namespace abut
