// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/stopwatch.h>
#include <abut/base/warning.h>
#include <abut/report/checkpoint.h>

namespace abut
{
  /// Saves the state of a run in the folder of its results, as often as the scene asks for.
  class CheckpointWriter
  {
  public:
    /// The scene must outlive it. Reads the scene's mesh files where there will be something to save. Throws
    /// UserError where one is gone.
    CheckpointWriter(const Scene &scene, std::string directory);

    /// Between two passes. Where nothing can be written the run goes on, and the last checkpoint stays.
    void save(const RunState &state, const History &history, const PassDrawings &drawings);

    /// Says where the last attempt has failed.
    std::vector<Warning> warnings() const;

  private:
    bool is_due() const;

    const Scene &scene_;
    std::string directory_, failure_;
    std::vector<std::string> mesh_checksums_;
    WallClock since_last_; ///< or since the beginning
    double cost_ = 0.;     ///< seconds of the last one
  };
} // namespace abut
