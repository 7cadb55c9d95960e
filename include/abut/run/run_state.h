// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/mesh/cell_marks.h>
#include <abut/results/results.h>
#include <abut/run/model.h>

#include <optional>
#include <vector>

namespace abut
{
  /// What a run has come to between two passes: all that the next ones need beside the scene. Meshes are made
  /// again by their marks, one adaptation after the other.
  struct RunState
  {
    std::vector<std::vector<CellMarks>> marks; ///< of every adaptation, body by body
    std::optional<CarriedState> carried;       ///< on the present meshes; none before the first pass
    Bytes pass;                                ///< what the Pass keeps, see Pass::serialize
    std::vector<PassRecord> passes;
    std::vector<BodyCounters> counters; ///< of every body
    Times times;
    double seconds = 0.; ///< since the run began
    /// That shared it: numbers of cells and unknowns depend on them where they share a mesh.
    unsigned int n_processes = 1;

    void serialize(Archive &archive)
    {
      archive(marks, carried, pass, passes, counters, times, seconds, n_processes);
    }
  };
} // namespace abut
