// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/study/observed_run.h>

#include <vector>

namespace abut
{
  /// The runs that the paper's figures are made of. What a run stands for follows from its parameters; names
  /// are for people.
  struct PaperRuns
  {
    ObservedRun base;                  ///< the scene itself
    std::vector<ObservedRun> variants; ///< those of its section Study

    /// All of them, the scene itself first.
    std::vector<const ObservedRun *> all() const;
    /// The points of curves against delta: the variants that set Adaptation/Limit and nothing else and have
    /// reached what they were asked for.
    std::vector<const ObservedRun *> by_limit() const;
    /// Where the decomposition converges to: the first variant without the combined algorithm; null where
    /// there is none.
    const ObservedRun *iterated() const;
  };
} // namespace abut
