// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <abut/base/executor.h>
#include <abut/scene/scene.h>

#include <iosfwd>

namespace abut
{
  /// Solves a scene and writes its results; returns the exit status. All processes of the executor have to
  /// call it; the first one writes and tells. Throws UserError and ComputationError.
  int run_scene(const Scene &scene, const Executor &executor, bool quiet, std::ostream &out,
                std::ostream &err);

  /// The same for the run whose checkpoint is in a folder: goes on from there.
  int resume_run(const std::string &directory, const Executor &executor, bool quiet, std::ostream &out,
                 std::ostream &err);

  /// Prints what would be solved.
  int check_scene(const Scene &scene, std::ostream &out, std::ostream &err);
} // namespace abut
