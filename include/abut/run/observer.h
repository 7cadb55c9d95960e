// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/results/estimation.h>
#include <abut/results/results.h>
#include <abut/results/step_estimate.h>
#include <abut/run/run_state.h>

#include <functional>

namespace abut
{
  /// A pass as it stands, before the mesh changes; valid during the call that shows it.
  struct PassState
  {
    const Results &results;
    const Estimation &estimation; ///< empty where nothing is estimated
    const InterfaceProblem &problem;
  };

  /// Is told what happens in a run; each part may be empty.
  struct RunObserver
  {
    std::function<void(unsigned int pass, const Counts &counts)> begin_pass;
    StepObserver step;
    std::function<void(const StepEstimate &)> estimate; ///< after its step (Adaptation/Estimate steps)
    std::function<void(const PassRecord &)> end_pass;
    std::function<void(const PassState &)> state; ///< after end_pass
    std::function<void(const RunState &)>
        adapted; ///< when the meshes of the next pass are there; in all processes
  };
} // namespace abut
